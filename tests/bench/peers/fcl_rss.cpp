#include "bench/peers/fcl_rss.hpp"

#include <fcl/math/bv/RSS.h>

namespace snug::bench {

struct FclRss::All {
  std::vector<fcl::RSSd> rss;
};

FclRss::FclRss(const std::vector<Lozenge<double, 3>>& lozenges) : all_(std::make_unique<All>()) {
  for (const auto& lozenge : lozenges) {
    fcl::RSSd& rss = all_->rss.emplace_back();
    for (int i = 0; i < 2; ++i) {
      const auto& edge = lozenge.edges[i];
      rss.l[i] = edge.norm();
      rss.axis.col(i) = edge / rss.l[i];
    }
    rss.axis.col(2) = rss.axis.col(0).cross(rss.axis.col(1));
    rss.To = lozenge.origin;
    rss.r = lozenge.radius;
  }
}

FclRss::~FclRss() = default;

int FclRss::overlapping_pairs() const {
  int count = 0;
  for (std::size_t i = 0; i + 1 < all_->rss.size(); i += 2) count += all_->rss[i].overlap(all_->rss[i + 1]) ? 1 : 0;
  return count;
}

}  // namespace snug::bench
