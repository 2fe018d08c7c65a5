#include "common/plot/xmp.hpp"

namespace plot {
namespace {

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t';
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (control)
            result += "\uFFFD";
        else
            result += c;
    }
    return result;
}

/// An element with a text in the one language that XMP wants to be there.
std::string in_default_language(const std::string& element, const std::string& text) {
    return "<" + element + "><rdf:Alt><rdf:li xml:lang=\"x-default\">" + escaped(text) +
           "</rdf:li></rdf:Alt></" + element + ">\n";
}

}  // namespace

std::string xmp_packet(const std::string& title, const std::string& software, const std::string& comment) {
    return "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
           "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
           "<rdf:Description rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\" "
           "xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\">\n" +
           in_default_language("dc:title", title) + in_default_language("dc:description", comment) +
           "<xmp:CreatorTool>" + escaped(software) +
           "</xmp:CreatorTool>\n</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n";
}

}  // namespace plot
