#pragma once

namespace exact {

/// Throws std::domain_error "<problem>: <what> = <value> lies outside <range>" unless it `holds`.
void require(bool holds, const char* problem, const char* what, double value, const char* range);

}  // namespace exact
