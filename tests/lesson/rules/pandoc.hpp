#pragma once
#include <string>
#include <vector>

namespace lesson {

bool has_pandoc();
/// Whether pandoc reads every one of these formulas as TeX: one run for all.
bool reads(const std::vector<std::string>& formulas);
/// What pandoc says of a formula that it cannot read.
std::string complaint_of(const std::string& formula);

}  // namespace lesson
