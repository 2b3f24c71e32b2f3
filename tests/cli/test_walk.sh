#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Follows the tutorial in docs/crop.md, in which a user defines a crop.
source "$(dirname "$0")/common.sh"

# Writes each code block of this page to a file.
awk '/^```[a-z]/{name = "block" ++n; next} /^```/{name = ""} name{print > name}' \
    "$project/docs/crop.md"
cat block1 block2 block3 >millet.toml
mv block4 dryland.toml
[ "$(wc -l <block5)" -eq 5 ] || fail "not the five commands"
PATH=$(dirname "$ideotype"):$PATH
export IDEOTYPE_PYTHON=${IDEOTYPE_PYTHON:-$project/.venv/bin/python}
while read -r command; do
    expect 0 bash -c "$command"
done <block5
says "better_millet"
grep -q '^name = "better_millet"' better_millet.toml || fail "no crop file"
grep -q '^g sheath' better_millet.obj || fail "no sheaths"
grep -q '^g stalk_ear' better_millet.obj || fail "no ear"
# Free traits are within their bounds; all other traits are unchanged.
expect 0 "$ideotype" export results/dryland/*.h5 --generations --to all.csv
head -1 all.csv | tr , '\n' | grep -c '_insertion_angle_deg$' | grep -qx 3 ||
    fail "not an angle for each leaf"
head -1 all.csv | grep -q ',width_profile_1,width_profile_2,width_profile_3,height$' ||
    fail "no profile in $(head -1 all.csv)"
# An error in a user's file is reported with its position.
sed 's/leaf.width/leaf.widht/' millet.toml >wrong.toml
sed 's/millet.toml/wrong.toml/' dryland.toml >wrong_campaign.toml
expect 3 "$ideotype" check wrong_campaign.toml
says "wrong.toml:.*trait width_profile acts on .leaf.widht. .*did you mean .leaf.width."
