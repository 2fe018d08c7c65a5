#pragma once
#include <string>

namespace plot {

/// The texts of a file as an XMP packet (XML), as WebP has it: what PNGs have as Title, Software and Comment.
/// All in UTF-8; characters that XML does not allow become U+FFFD.
std::string xmp_packet(const std::string& title, const std::string& software, const std::string& comment);

}  // namespace plot
