#pragma once
#include <map>
#include <string>
#include <vector>

/// Sentences of a text that compare or conclude, and what the run that measures them says. A sentence stands
/// between `<!-- claim NAME -->` and `<!-- end -->` in the chapter's text; it may hold numbers that the
/// program fills. In the book's README.md, which all chapters share, the name is `04:NAME`.
namespace report {

/// What a run found of a sentence. `skipped`: a quick run has not measured what it speaks of.
enum class Verdict { holds, fails, skipped };
using Claims = std::map<std::string, Verdict>;

/// The names of the claims of a text, in its order, each once. Throws std::invalid_argument for a marker
/// without a name or without an end.
std::vector<std::string> claims_of(const std::string& markdown);

/// What is wrong between a chapter's text, the book's text and what the chapter's full run asserted, one line
/// each: a sentence that nothing asserts, an assertion without a sentence, and one that does not hold.
/// `number`: the chapter's, "04"; of the book's claims only those that begin with it count.
std::vector<std::string> broken_claims(const std::string& chapter, const std::string& book,
                                       const std::string& number, const Claims& asserted);
/// The names with that verdict, joined by ", ".
std::string names_with(Verdict verdict, const Claims& claims);

}  // namespace report
