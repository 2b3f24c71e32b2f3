#include "header.hpp"

#include <algorithm>

#include "dataset.hpp"
#include "layout.hpp"
#include "types.hpp"

namespace ideotype {

namespace {

Handle open_attribute(hid_t file, const std::string& name) {
    return {H5Aopen(file, name.c_str(), H5P_DEFAULT), H5Aclose,
            "open attribute " + name};
}

template <class Value>
Value attribute(hid_t file, const std::string& name, hid_t memory_type) {
    Value value{};
    checked(H5Aread(open_attribute(file, name), memory_type, &value),
            "read attribute " + name);
    return value;
}

std::string read_text(hid_t attribute) {
    const std::string action = "read an attribute";
    const Handle type(H5Aget_type(attribute), H5Tclose, action);
    std::string text(H5Tget_size(type), '\0');
    checked(H5Aread(attribute, type, text.data()), action);
    text.resize(std::min(text.find('\0'), text.size()));
    return text;
}

// Sorts an attribute into the header by its type.
herr_t keep_attribute(hid_t file, const char* name, const H5A_info_t*,
                      void* target) {
    auto& header = *static_cast<HistoryHeader*>(target);
    try {
        const Handle type(H5Aget_type(open_attribute(file, name)), H5Tclose,
                          "read an attribute");
        const H5T_class_t kind = H5Tget_class(type);
        if (kind == H5T_STRING)
            header.text[name] = read_text(open_attribute(file, name));
        if (kind == H5T_FLOAT)
            header.numbers[name] =
                attribute<double>(file, name, H5T_NATIVE_DOUBLE);
        return 0;
    } catch (const Hdf5Error&) {
        return -1;  // an exception must not pass through C
    }
}

template <class Item, class Get>
void create_column(hid_t group, const std::string& name,
                   const std::vector<Item>& items, const std::string& label,
                   Get get) {
    std::vector<std::string> texts;
    for (const Item& item : items) texts.push_back(get(item));
    label_dimension(create_texts(group, name, texts), 0, label);
}

void write_genes(hid_t file, const GeneSpace& genes) {
    const Handle group = create_group(file, "traits");
    create_column(group, "name", genes, "gene",
                  [](const Gene& gene) { return gene.name; });
    create_column(group, "unit", genes, "gene",
                  [](const Gene& gene) { return gene.unit; });
    std::vector<double> lower, upper;
    std::vector<std::int8_t> is_circular, is_free;
    for (const Gene& gene : genes) {
        lower.push_back(gene.lower);
        upper.push_back(gene.upper);
        is_circular.push_back(gene.is_circular);
        is_free.push_back(gene.is_free);
    }
    const auto add = [&](const std::string& name, hid_t type,
                         const std::string& unit, const auto& values) {
        label_dimension(create_dataset(group, {.name = name,
                                               .type = type,
                                               .sizes = {values.size()},
                                               .unit = unit}),
                        0, "gene");
        Dataset(group, name).write(0, values);
    };
    add("lower", H5T_IEEE_F64LE, "/traits/unit", lower);
    add("upper", H5T_IEEE_F64LE, "/traits/unit", upper);
    add("is_circular", bool_type(), "1", is_circular);
    add("is_free", bool_type(), "1", is_free);
}

GeneSpace read_genes(hid_t file) {
    const Dataset name(file, "traits/name");
    const hsize_t count = name.rows();
    const auto names = name.read_text(0, count);
    const auto units = Dataset(file, "traits/unit").read_text(0, count);
    const auto lower = Dataset(file, "traits/lower").read<double>(0, count);
    const auto upper = Dataset(file, "traits/upper").read<double>(0, count);
    const auto is_circular =
        Dataset(file, "traits/is_circular").read<std::int8_t>(0, count);
    const auto is_free =
        Dataset(file, "traits/is_free").read<std::int8_t>(0, count);
    GeneSpace genes;
    for (std::size_t i = 0; i < count; ++i)
        genes.push_back({names[i], units[i], lower[i], upper[i],
                         is_circular[i] != 0, is_free[i] != 0});
    return genes;
}

void write_quantities(hid_t file, const std::string& group_name,
                      const std::vector<Quantity>& quantities,
                      const std::string& label) {
    const Handle group = create_group(file, group_name);
    create_column(group, "name", quantities, label,
                  [](const Quantity& quantity) { return quantity.name; });
    create_column(group, "unit", quantities, label,
                  [](const Quantity& quantity) { return quantity.unit; });
}

std::vector<Quantity> read_quantities(hid_t file, const std::string& group) {
    const Dataset name(file, group + "/name");
    const auto names = name.read_text(0, name.rows());
    const auto units = Dataset(file, group + "/unit").read_text(0, name.rows());
    std::vector<Quantity> quantities;
    for (std::size_t i = 0; i < names.size(); ++i)
        quantities.push_back({names[i], units[i]});
    return quantities;
}

}  // namespace

void write_header(hid_t file, const HistoryHeader& header) {
    create_attribute(file, "format", format_name);
    create_attribute(file, "format_version", format_version);
    create_attribute(file, "seed", H5T_NATIVE_UINT64, &header.seed);
    create_attribute(file, "population", H5T_NATIVE_INT, &header.population);
    create_attribute(file, "generations", H5T_NATIVE_INT, &header.generations);
    create_attribute(file, "finalists", H5T_NATIVE_INT, &header.finalists);
    for (const auto& [name, text] : header.text)
        create_attribute(file, name, text);
    for (const auto& [name, number] : header.numbers)
        create_attribute(file, name, H5T_NATIVE_DOUBLE, &number);
    const Handle campaign = create_group(file, "campaign");
    create_text(campaign, "source", header.campaign_source);
    create_text(campaign, "resolved", header.campaign_resolved);
    write_genes(file, header.genes);
    write_quantities(file, "objectives", header.schema.objectives, "objective");
    write_quantities(file, "diagnostics", header.schema.diagnostics,
                     "diagnostic");
}

HistoryHeader read_header(hid_t file) {
    HistoryHeader header;
    checked(H5Aiterate2(file, H5_INDEX_NAME, H5_ITER_INC, nullptr,
                        keep_attribute, &header),
            "read the attributes");
    header.seed = attribute<std::uint64_t>(file, "seed", H5T_NATIVE_UINT64);
    header.population = attribute<int>(file, "population", H5T_NATIVE_INT);
    header.generations = attribute<int>(file, "generations", H5T_NATIVE_INT);
    header.finalists = attribute<int>(file, "finalists", H5T_NATIVE_INT);
    header.campaign_source =
        Dataset(file, "campaign/source").read_text(0, 1)[0];
    header.campaign_resolved =
        Dataset(file, "campaign/resolved").read_text(0, 1)[0];
    header.genes = read_genes(file);
    header.schema.objectives = read_quantities(file, "objectives");
    header.schema.diagnostics = read_quantities(file, "diagnostics");
    return header;
}

std::string text_attribute(hid_t file, const std::string& name) {
    if (checked(H5Aexists(file, name.c_str()), "find attribute " + name) == 0)
        return "";
    const Handle attribute = open_attribute(file, name);
    const Handle type(H5Aget_type(attribute), H5Tclose, "read " + name);
    return H5Tget_class(type) == H5T_STRING ? read_text(attribute) : "";
}

}  // namespace ideotype
