// SPDX-License-Identifier: Apache-2.0
// `fuzz_X SECONDS SEED_FILE...`: a substitute for libFuzzer that tries modified
// copies of the files. Their order is always the same, so that a second run in
// a debugger ends at the same input.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size);

namespace {

using Text = std::string;

class Mutator {
  public:
    explicit Mutator(std::vector<Text> seeds) : seeds_(std::move(seeds)) {}

    Text next() {
        Text text = any(seeds_);
        for (std::size_t changes = 1 + below(8); changes > 0; --changes)
            change(text);
        return text;
    }

  private:
    std::size_t below(std::size_t n) { return n == 0 ? 0 : engine_() % n; }

    const Text& any(const std::vector<Text>& all) {
        return all[below(all.size())];
    }

    //! Changes one byte, inserts a word that is likely to cause an error, or
    //! moves or removes a part.
    void change(Text& text) {
        static const std::vector<Text> words{
            "-1",  "0",    "nan", "1e999",       "99999999999", "\n",
            "f ",  "v ",   "=",   "[",           "]",           "\"",
            "'''", "\xff", ".",   Text(1, '\0'), "2025-02-30",  "\\\n"};
        const std::size_t at = below(text.size() + 1);
        const std::size_t length =
            below(std::min<std::size_t>(64, text.size()));
        switch (below(4)) {
            case 0:
                if (at < text.size()) text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.insert(at, any(words));
                break;
            case 2:
                text.erase(at, length);
                break;
            default: {
                const Text& other = any(seeds_);
                text.insert(at, other, below(other.size() + 1), length);
            }
        }
    }

    std::vector<Text> seeds_;
    std::mt19937_64 engine_{1};
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::cerr << "usage: " << argv[0] << " SECONDS SEED_FILE...\n";
        return 2;
    }
    std::vector<Text> seeds;
    for (int i = 2; i < argc; ++i) {
        std::ifstream stream(argv[i], std::ios::binary);
        // The beginning of a large file is sufficient, and faster.
        Text text{std::istreambuf_iterator<char>(stream), {}};
        seeds.push_back(text.substr(0, 16384));
    }
    Mutator mutator(seeds);
    using Clock = std::chrono::steady_clock;
    const auto end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(
                           std::chrono::duration<double>(std::atof(argv[1])));
    std::size_t inputs = 0;
    for (; Clock::now() < end; ++inputs) {
        const Text text = mutator.next();
        LLVMFuzzerTestOneInput(
            reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    }
    std::cout << inputs << " inputs without a finding\n";
    return 0;
}
