// What experiments on a cloud of points have in common: their subject is the cloud, as far as points, edits and runs
// go, and their rows differ from the cloud's in what is measured and asked.
#pragma once

#include <memory>
#include <utility>

#include "lesson/point_subject.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {

class OnCloud : public Subject, public HasPoints {
 public:
  [[nodiscard]] const Subject& shape() const override { return *cloud_; }
  void set_origin(Origin origin) override { cloud_->set_origin(origin), origin_ = std::move(origin); }
  [[nodiscard]] std::vector<Drive> drives() const override { return cloud_->drives(); }
  Done drive(std::string_view name, double from, double to) override { return edited(cloud_->drive(name, from, to)); }
  [[nodiscard]] int dim() const override { return cloud_->dim(); }
  [[nodiscard]] Index size() const override { return cloud_->size(); }
  [[nodiscard]] Point3 at(Index i) const override { return cloud_->at(i); }
  [[nodiscard]] std::string name_of(Index i) const override { return cloud_->name_of(i); }
  [[nodiscard]] Tools tools() const override { return cloud_->tools(); }
  [[nodiscard]] Rows rows() const override { return cloud_->rows(); }
  Done set_rows(const Rows& rows) override { return edited(cloud_->set_rows(rows)); }
  [[nodiscard]] const AnyPointSet& set_of_points() const override { return cloud_points().set_of_points(); }
  [[nodiscard]] std::span<const std::array<Index, 3>> triangles() const override { return cloud_points().triangles(); }
  Done move(Index i, const Point3& to) override { return edited(cloud_->move(i, to)); }
  Done add(const Point3& at) override { return edited(cloud_points().add(at)); }
  Done remove(Index i) override { return edited(cloud_points().remove(i)); }
  Done load(const io::PointFile& file, std::string_view name) override {
    return edited(cloud_points().load(file, name));
  }
  Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own) override {
    return edited(cloud_points().set_generator(kind, count, dim, seed, own.shape()));
  }
  void scatter(std::uint64_t seed, const Subject& own) override {
    cloud_->scatter(seed, own.shape());
    static_cast<void>(edited({}));
  }
  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override {
    return cloud_->run(method, std::move(earlier));
  }
  [[nodiscard]] std::string opening(const Method& method) const override { return cloud_->opening(method); }
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override { return cloud_->figures(view); }
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override { return cloud_->proofs(view); }

 protected:
  [[nodiscard]] Abilities abilities() override { return {.points = this}; }
  explicit OnCloud(std::unique_ptr<Subject> cloud) : cloud_(std::move(cloud)) { origin_ = cloud_->origin(); }
  OnCloud(const OnCloud& other) : Subject(other), cloud_(other.cloud_->clone()) {}
  OnCloud& operator=(const OnCloud&) = delete;

  [[nodiscard]] Subject& cloud() { return *cloud_; }
  [[nodiscard]] const Subject& cloud() const { return *cloud_; }
  /// Takes over what an edit made of the cloud.
  Done edited(Done done) {
    if (!done) return done;
    origin_ = cloud_->origin();
    points_changed();
    return done;
  }
  /// Called when the points have changed, and what was measured of them is stale.
  virtual void points_changed() = 0;

 private:
  [[nodiscard]] HasPoints& cloud_points() { return *cloud_->with_points(); }
  [[nodiscard]] const HasPoints& cloud_points() const { return *cloud().with_points(); }

  std::unique_ptr<Subject> cloud_;
};

[[nodiscard]] std::vector<std::string_view> volumes_on_cloud();
/// The catalogue's. The cloud's methods by hand are not among them, for they cannot be timed.
[[nodiscard]] std::span<const Method> methods_on_cloud(std::string_view volume);
/// Nothing is asked of a step.
[[nodiscard]] std::vector<std::string_view> no_facts();
void read_on_cloud(TomlTable& table, Lesson& lesson, Complaints& complaints);
[[nodiscard]] tl::expected<std::unique_ptr<Subject>, InputError>
open_cloud_of(const Lesson& lesson, std::optional<io::PointFile> mesh, Clock clock);
/// Those that the lesson offers, in order.
[[nodiscard]] std::vector<const Method*> methods_of(const Lesson& lesson);

/// Question kinds of no fact.
template <const auto& kKinds>
[[nodiscard]] std::vector<FactQuestionKind> of_no_fact() {
  std::vector<FactQuestionKind> all;
  for (const QuestionKind& kind : kKinds) all.push_back({"", &kind});
  return all;
}

/// The row of an experiment, with what it has of the cloud.
[[nodiscard]] constexpr SubjectRow row_on_cloud(SubjectRow own) {
  own.table = "points";
  own.volumes = &volumes_on_cloud;
  own.methods = &methods_on_cloud;
  own.facts = &no_facts;
  if (own.read == nullptr) own.read = &read_on_cloud;
  if (own.read_model == nullptr) own.read_model = &read_point_model;
  return own;
}

}  // namespace snug::lesson
