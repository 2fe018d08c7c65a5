#include "common/exact/program/solutions.hpp"

namespace exact::program {

std::vector<std::unique_ptr<Solution>> solutions() {
    std::vector<std::unique_ptr<Solution>> list;
    list.push_back(burgers());
    return list;
}

}  // namespace exact::program
