#include "app/app.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>

#include "app/commands.hpp"
#include "app/inspector.hpp"
#include "app/look.hpp"
#include "app/stage.hpp"
#include "app/subjects.hpp"
#include "app/timeline.hpp"
#include "app/widgets.hpp"
#include "lesson/demo.hpp"
#include "lesson/demo_reveal.hpp"
#include "lesson/invitations.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

// The shortest and the longest time for playing the steps up to an outcome.
constexpr double kWatchedSeconds = 2, kLongestWatched = 4;
constexpr double kSecondsOfStep = 0.5;
constexpr int kSettleFrames = 2;  // ImGui answers an input over this many frames
constexpr double kOrbitStep = 0.2, kZoomStep = 1.25;

/// Whether someone is at the controls in this frame: what was hovered or pressed has yet to be drawn.
bool has_input(const ImGuiIO& io) {
  return io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0 || io.MouseWheelH != 0 ||
         std::any_of(std::begin(io.MouseClicked), std::end(io.MouseClicked), std::identity{}) ||
         std::any_of(std::begin(io.MouseReleased), std::end(io.MouseReleased), std::identity{}) ||
         io.InputQueueCharacters.Size > 0;
}

bool same(const Settings& a, const Settings& b) {
  return a.theme == b.theme && a.text_scale == b.text_scale && a.least_words == b.least_words &&
         a.reduced_motion == b.reduced_motion && a.prose_in_canvas == b.prose_in_canvas && a.tools == b.tools &&
         a.show_optimum == b.show_optimum && a.labels == b.labels && a.ground == b.ground;
}

}  // namespace

void whiten(const ImFontAtlas& atlas) {
  for (ImTextureData* texture : atlas.TexList) {
    if (texture->Status != ImTextureStatus_WantCreate || texture->BytesPerPixel != 4) continue;
    unsigned char* const end = texture->Pixels + texture->Width * texture->Height * 4;
    for (unsigned char* pixel = texture->Pixels; pixel != end; pixel += 4)
      if (pixel[3] == 0) std::fill(pixel, pixel + 3, static_cast<unsigned char>(255));
  }
}

struct App::State {
  Platform platform;
  Settings settings, drawn_settings;
  std::array<std::string, 4> font_bytes;  // ImGui reads glyphs from them on demand
  Look look;
  std::optional<lesson::Session> session;
  std::optional<lesson::Sitting> sitting;              // at the exercise that is open
  std::map<std::string, lesson::KeptAnswers> answers;  // those of lessons that were left, by id
  const SubjectRow* subject = nullptr;                 // the session's subject, and its view
  std::unique_ptr<SubjectView> view;
  std::unique_ptr<Cover> cover;
  Stage stage;
  StageGl gl;
  lesson::Invitations invitations;
  std::optional<Invitation> invitation;
  std::string invited_handle;  // which one is to be dragged
  Rect step_button, play_button;
  bool playing = false;
  float speed = 1;
  double next_step_at = 0;
  double watched_pause = 0;  // seconds per step while the way to an outcome is played; 0: none is played
  double watched_until = 0;  // when that ends, even if not all steps were shown
  bool press_ends = false;   // the press that ended it does nothing else
  double now = 0;
  std::uint64_t drawn_revision = 0;
  int drawn_cover = 0, drawn_percent = 0;
  int settle = kSettleFrames;
  bool to_top = false;  // another lesson's numbers begin at their top
  long frames = 0;
  float figures_height = 0;

  void load_fonts();
  void refresh_look(bool fingers);
  /// Seconds per step while playing at speed 1: of frames the time that one simulates. watched: the least time per step
  /// while the steps up to an outcome are played, in which a frame would be too short to see; otherwise 0.
  [[nodiscard]] double seconds_of_step(double watched) const {
    const lesson::HasFrames* const frames = session->stage().subject().frames();
    return frames != nullptr ? std::max(frames->seconds_of_frame(), watched) : kSecondsOfStep;
  }
  /// Seconds from one playing step to the next.
  [[nodiscard]] double pause() const {
    return watched_pause > 0 ? watched_pause : seconds_of_step(0) / static_cast<double>(speed);
  }
  void play_on();
  [[nodiscard]] bool player(std::string_view name);
  [[nodiscard]] bool edit(std::string_view name);
  [[nodiscard]] bool choose_target(int by);
  [[nodiscard]] bool select(std::string_view name);
  [[nodiscard]] bool look_around(std::string_view name);
  [[nodiscard]] bool move(std::string_view name);
  [[nodiscard]] int percent() const { return cover != nullptr ? static_cast<int>(100 * cover->progress()) : 0; }
  void decide_by_measuring();
  [[nodiscard]] bool covered() const { return cover != nullptr && cover->shown(); }
  void draw_stage(const Rect& rect);
  void invite(const Rect& rect);
  [[nodiscard]] std::optional<Rect> handle_to_drag(const Rect& rect);
  void open(lesson::Session next, bool anew);
  void forget();
  void set_speed(int by);
  void toggle_play();
  void next_mark();
  void watch();
  void end_watching();
  [[nodiscard]] bool go_on(std::string_view name);
};

void App::State::load_fonts() {
  constexpr std::array<std::string_view, 4> kNames{"Inter-Regular", "Inter-SemiBold", "JetBrainsMono-Regular",
                                                   "JetBrainsMono-Bold"};
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  for (std::size_t i = 0; i < kNames.size(); ++i)
    font_bytes[i] = platform.font != nullptr ? platform.font(kNames[i]) : std::string();
  const auto add = [&](std::size_t i, bool merge) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.MergeMode = merge;
    if (font_bytes[i].empty()) return static_cast<ImFont*>(nullptr);
    return atlas->AddFontFromMemoryTTF(font_bytes[i].data(), static_cast<int>(font_bytes[i].size()), 15, &config);
  };
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    look.fonts[i] = add(i, false);
    add((i + 2) % 4, true);  // what Inter lacks (∈, ∪ …); accents, which figures and code go without
  }
  // A door that could not read one face shows its words in another.
  ImFont* any = *std::find_if(look.fonts.begin(), look.fonts.end() - 1, [](ImFont* font) { return font != nullptr; });
  for (ImFont*& font : look.fonts)
    if (font == nullptr) font = any;
}

void App::State::refresh_look(bool fingers) {
  look.palette = &palette_of(settings.theme);
  look.text_scale = settings.text_scale * look.palette->text, look.least = settings.least_words;
  look.fingers = fingers;
  look.still = settings.reduced_motion;
  apply_style(look);
}

/// After an answer: plays the skipped steps, fast enough to show all of them in time. With reduced motion, they are
/// played only on request.
void App::State::watch() {
  session->conversation().play_answers(!settings.reduced_motion);
  const lesson::Outcome* const outcome = session->conversation().deciding();
  if (outcome == nullptr) watched_pause = 0;
  if (outcome == nullptr || (watched_pause > 0 && now < watched_until)) return;
  if (watched_pause > 0) return end_watching();  // without one more step, which would continue
  const int steps = std::max(1, outcome->step - session->player().step());
  watched_pause = std::min(seconds_of_step(kWatchedSeconds / steps), kLongestWatched / steps);
  watched_until = now + kLongestWatched;
  playing = true;
  next_step_at = now + watched_pause;
}

void App::State::end_watching() {
  session->conversation().decide();
  playing = false;
  watched_pause = 0;
  settle = std::max(settle, 1);
}

/// Takes the steps that are due.
void App::State::play_on() {
  watch();
  if (!playing) return;
  if (now - next_step_at > 1) next_step_at = now;  // nothing was drawn for a while: do not catch up
  while (playing && now >= next_step_at) {
    session->forward();
    next_step_at += pause();
    if (session->conversation().outcome() != nullptr || session->conversation().asked() != nullptr ||
        session->player().step() == session->player().steps())
      playing = false;
  }
  if (session->conversation().deciding() == nullptr) watched_pause = 0;
}

void App::State::toggle_play() {
  playing = !playing && session->conversation().asked() == nullptr;
  if (!playing) return;
  if (session->player().step() == session->player().steps() && !session->player().previewing()) session->go(0);
  next_step_at = now + (session->player().previewing() ? 0 : pause());
}

void App::State::next_mark() {
  if (session->player().previewing()) session->forward();
  else session->go(session->player().next_mark());
}

/// The "next" keys and buttons: they continue from an outcome, and skip a question at their second press.
bool App::State::go_on(std::string_view name) {
  const bool steps = name == "next_mark" || name == "step";
  if (sitting && sitting->looks_at(*session) == lesson::Sitting::Looked::kOwn) {
    if (steps && sitting->step_own(*session, 1)) return true;
    if (name == "back" || name == "previous_mark") return sitting->step_own(*session, -1), true;
    if (name == "play") sitting->change_run(*session);  // it is the right run that plays
  }
  if (name == "other_run") return sitting && sitting->change_run(*session);
  if (steps || name == "play" || name == "commit_answer" || name == "continue")
    if (session->conversation().acknowledge()) return true;
  const lesson::Asked* const asked = session->conversation().asked();
  const bool gate = asked != nullptr && (asked->step != lesson::Asked::kAnytime || name == "next_mark");
  if (steps && gate) return session->conversation().pass_by();
  if (name == "hint") return sitting && sitting->take_hint(*session);
  if (name == "take_back") return session->conversation().take_back();
  if (name == "back_to_best") return sitting && sitting->back_to_best(*session);
  if (name == "finish") return sitting && sitting->finish();
  if (name == "show_model") return sitting && sitting->show_model(*session);
  if (name == "predict_again") {
    if (sitting) return false;
    forget();
    if (session->lesson().subject->asks_of_steps) session->go(0);
    return true;
  }
  if (name == "practise") return session->conversation().practise();
  if (name == "close_summary" ||
      ((name == "continue" || name == "commit_answer") && session->conversation().at_summary()))
    return session->conversation().at_summary() && (session->conversation().close_summary(), true);
  if (name == "show_answer") return session->conversation().show_answer();
  if (name == "watch_outcome") return session->conversation().watch_outcome() && (watch(), true);
  constexpr std::string_view kReview = "review:";
  return name.starts_with(kReview) && session->conversation().review(name.substr(kReview.size()));
}

void App::State::set_speed(int by) {
  const auto at = std::find(kSpeeds.begin(), kSpeeds.end(), speed) - kSpeeds.begin();
  speed = kSpeeds[std::clamp<std::ptrdiff_t>(at + by, 0, static_cast<std::ptrdiff_t>(kSpeeds.size()) - 1)];
}

bool App::State::player(std::string_view name) {
  const int before = session->player().step();
  const bool previewing = session->player().previewing(), asks = session->conversation().asked() != nullptr;
  if (go_on(name)) return playing = session->conversation().deciding() != nullptr, true;
  if (name == "play") return toggle_play(), true;
  if (name == "slower") return set_speed(-1), true;
  if (name == "faster") return set_speed(1), true;
  if (name == "first") session->go(0);
  else if (name == "back") session->go(session->player().step() - 1);
  else if (name == "step") session->forward();
  else if (name == "last") session->last();
  else if (name == "next_mark") next_mark();
  else if (name == "previous_mark") session->go(session->player().previous_mark());
  else if (name == "skip_question") return session->conversation().give({}, false);
  else if (name == "commit_answer") return session->conversation().commit();
  else return false;
  playing = false;
  return session->player().step() != before || session->player().previewing() != previewing ||
         (session->conversation().asked() != nullptr) != asks;
}

/// Starts what decides the predictions about the cover, once all of them are given and one waits for it.
void App::State::decide_by_measuring() {
  const auto waits = [](const lesson::Outcome& outcome) { return outcome.pending && !outcome.skipped; };
  if (cover == nullptr || cover->running() || session->conversation().to_predict() != nullptr) return;
  if (std::any_of(session->log().outcomes().begin(), session->log().outcomes().end(), waits))
    cover->command(*session, "measure");
}

bool App::State::edit(std::string_view name) {
  if (name == "undo" || name == "redo") {
    if (name == "undo" ? !session->stage().can_undo() : !session->stage().can_redo()) return false;
    name == "undo" ? session->stage().undo() : session->stage().redo();
    return true;
  }
  if (name == "add_point") return stage.add_point(*session);
  if (name == "delete_point") return stage.delete_point(*session);
  if (name == "push") return session->conversation().asked() == nullptr && session->player().push(stage.selected());
  if (name == "scatter") return session->stage().scatter(session->stage().subject().origin().seed + 1), true;
  if (name == "reset_points") return session->stage().reset(), true;
  return false;
}

/// Selects the next or previous possible answer among the handles; false if the question is not answered on the stage.
bool App::State::choose_target(int by) {
  const std::vector<Index> targets = session->conversation().targets();
  if (targets.empty() || session->conversation().asked()->many) return false;  // of many, each is tapped or named
  const auto n = static_cast<std::ptrdiff_t>(targets.size());
  const lesson::Answer* picked = session->conversation().picked();
  if (picked == nullptr) picked = session->conversation().tried();
  const auto* one = picked != nullptr ? std::get_if<lesson::OneHandle>(picked) : nullptr;
  const std::ptrdiff_t at =
      one != nullptr ? std::find(targets.begin(), targets.end(), one->handle) - targets.begin() : -1;
  const std::ptrdiff_t next = at < 0 ? (by > 0 ? 0 : n - 1) : (at + by + n) % n;
  if (next != at) static_cast<void>(session->conversation().pick(lesson::OneHandle{targets[next]}, false));
  return true;
}

bool App::State::select(std::string_view name) {
  const bool next = name == "select_next";
  if ((next || name == "select_previous") && choose_target(next ? 1 : -1)) return true;
  if (name == "select_none" && session->conversation().picked() != nullptr)
    return session->conversation().unpick(), true;
  const Index n = session->stage().subject().size(), at = stage.selected();
  const auto select_from = [&](Index to, Index by) {
    while (!stage.shows(*session, to)) to = (to + n + by) % n;
    stage.select(to);
  };
  if (name == "select_next") select_from(at == kNoIndex ? 0 : (at + 1) % n, 1);
  else if (name == "select_previous") select_from(at == kNoIndex ? n - 1 : (at + n - 1) % n, -1);
  else if (name == "select_none" && at != kNoIndex) stage.select(kNoIndex);
  else return false;
  return true;
}

bool App::State::look_around(std::string_view name) {
  if (name == "reset_view") stage.reset_view(*session);
  else if (name == "zoom_in") stage.zoom_by(kZoomStep);
  else if (name == "zoom_out") stage.zoom_by(1 / kZoomStep);
  else if (name == "toggle_optimum") settings.show_optimum = !settings.show_optimum;
  else if (name == "orbit_left") return stage.orbit_by(-kOrbitStep, 0);
  else if (name == "orbit_right") return stage.orbit_by(kOrbitStep, 0);
  else if (name == "orbit_up") return stage.orbit_by(0, kOrbitStep);
  else if (name == "orbit_down") return stage.orbit_by(0, -kOrbitStep);
  else return false;
  return true;
}

bool App::State::move(std::string_view name) {
  constexpr std::string_view kFine = "_fine";
  const bool fine = name.size() > kFine.size() && name.substr(name.size() - kFine.size()) == kFine;
  if (fine) name.remove_suffix(kFine.size());
  if (name == "move_left") return stage.nudge(*session, -1, 0, 0, fine);
  if (name == "move_right") return stage.nudge(*session, 1, 0, 0, fine);
  if (name == "move_up") return stage.nudge(*session, 0, 1, 0, fine);
  if (name == "move_down") return stage.nudge(*session, 0, -1, 0, fine);
  if (name == "move_nearer") return stage.nudge(*session, 0, 0, -1, fine);
  if (name == "move_farther") return stage.nudge(*session, 0, 0, 1, fine);
  return false;
}

/// Draws the stage or its cover, and the button that switches between them.
void App::State::draw_stage(const Rect& rect) {
  const std::string words = cover != nullptr ? cover->button().words : std::string();
  const float height = look.fingers ? 44.0f : look.px(32);
  look.tools_right =
      cover != nullptr && settings.tools ? app::measure(look, Face::kSemiBold, 13, words).x + look.px(28) : 0;
  const Rect above{rect.x, rect.y, rect.width, rect.height - look.foot};
  if (covered()) {
    // A question's card does not reach from side to side: the ground beside it is the cover's.
    ImGui::GetWindowDrawList()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height},
                                              look->ground);
    cover->draw(look, *session, above, settings.prose_in_canvas && look.foot <= 0);
  } else {
    stage.draw(look, settings, *session, rect, now);
  }
  if (cover == nullptr || !settings.tools) return;
  const float right = rect.x + rect.width - 12 - (covered() ? 0 : height + 8);
  if (button(ImGui::GetWindowDrawList(), look,
             {.id = "chart or shape",
              .rect = {right - look.tools_right, rect.y + 12, look.tools_right, height},
              .words = words,
              .kind = ButtonKind::kOutlined,
              .size = 13}))
    cover->show(!cover->shown());
}

/// The rightmost, and the same one as long as it is there.
std::optional<Rect> App::State::handle_to_drag(const Rect& rect) {
  constexpr float kReach = 12;
  std::vector<Handle> all = stage.handles(*session);
  std::erase_if(all, [&](const Handle& one) {
    return one.x < rect.x || one.y < rect.y || one.x > rect.x + rect.width || one.y > rect.y + rect.height;
  });
  if (all.empty()) return std::nullopt;
  auto chosen = std::find_if(all.begin(), all.end(), [&](const Handle& one) { return one.id == invited_handle; });
  if (chosen == all.end())
    chosen = std::max_element(all.begin(), all.end(), [](const Handle& a, const Handle& b) { return a.x < b.x; });
  invited_handle = chosen->id;
  return Rect{chosen->x - kReach, chosen->y - kReach, 2 * kReach, 2 * kReach};
}

void App::State::invite(const Rect& rect) {
  invitation.reset();
  const auto due = invitations.due(*session, playing);
  if (!due) return;
  const auto at = *due == lesson::Invited::kDrag   ? handle_to_drag(rect)
                  : *due == lesson::Invited::kStep ? std::optional(step_button)
                                                   : std::optional(play_button);
  if (at) invitation = Invitation{lesson::invitation_text(*due, invited_handle, step_words(*session)), *at};
}

/// What was measured would give the answers away.
void App::State::forget() {
  session->forget_answers();
  if (cover != nullptr) cover->show(false);
}

App::App(const Platform& platform) : state_(std::make_unique<State>()) {
  state_->platform = platform;
  state_->load_fonts();
  ImGui::GetIO().IniFilename = nullptr;
}
App::~App() = default;

bool App::create_graphics() {
  state_->settle = kSettleFrames;
  return state_->gl.create(state_->platform.glsl_version);
}
void App::abandon_graphics() { state_->gl.abandon(); }
const std::string& App::graphics_error() const { return state_->gl.error(); }

tl::expected<void, InputError> App::open(lesson::Lesson lesson, std::optional<io::PointFile> mesh, bool anew) {
  auto session = lesson::Session::open(std::move(lesson), std::move(mesh), state_->platform.clock);
  if (!session) return tl::unexpected(std::move(session.error()));
  state_->open(std::move(*session), anew);
  lesson::take_up(*state_->session, state_->answers[state_->session->lesson().id]);
  invite(lesson::Invitations::kAll);
  return {};
}

tl::expected<void, InputError> App::open_exercise(std::shared_ptr<const lesson::Exercise> exercise, std::uint64_t seed,
                                                  bool practises) {
  const auto instance = make_instance(*exercise, seed);
  if (!instance) return tl::unexpected(instance.error());
  auto session = open_instance(*exercise, *instance, state_->platform.clock, practises);
  if (!session) return tl::unexpected(std::move(session.error()));
  state_->open(std::move(*session), false);
  state_->sitting.emplace(std::move(exercise), seed, *state_->session, practises);
  invite(lesson::Invitations::kAll);
  return {};
}
lesson::Sitting* App::sitting() { return state_->sitting ? &*state_->sitting : nullptr; }

void App::State::open(lesson::Session next, bool anew) {
  if (session && !sitting) answers[session->lesson().id] = {session->log().outcomes(), session->done_tasks()};
  sitting.reset();
  session.emplace(std::move(next));
  session->stage().give_way(platform.gives_way);
  subject = &subject_of(session->lesson());
  view = subject->view();
  cover = subject->cover != nullptr ? subject->cover(platform) : nullptr;
  if (anew) stage.open_anew(*session, *view);
  else stage.open(*session, *view);
  stage.light("");
  to_top = !anew;
  playing = false;
  watched_pause = 0;
  settle = kSettleFrames;
}

void App::keep_answers(const std::string& lesson, lesson::KeptAnswers answers) {
  state_->answers[lesson] = std::move(answers);
}
void App::forget_answers() {
  state_->answers.clear();
  if (state_->session) state_->forget();
}

tl::expected<void, InputError> App::load(const io::PointFile& file, std::string_view name) {
  return state_->cover ? state_->cover->load(*state_->session, file, name) : state_->session->stage().load(file, name);
}
std::string_view App::subject() const {
  return state_->subject != nullptr ? state_->subject->name : std::string_view();
}
Cover* App::cover() { return state_->cover.get(); }
void App::measure(double budget) {
  if (state_->cover) state_->cover->work(*state_->session, budget);
}

lesson::Session* App::session() { return state_->session ? &*state_->session : nullptr; }
Settings& App::settings() { return state_->settings; }
const Look& App::look() const { return state_->look; }

bool App::end_playing() {
  const bool plays = state_->session && state_->session->conversation().deciding() != nullptr;
  if (plays) state_->end_watching();
  return plays;
}

bool App::command(std::string_view name) {
  State& s = *state_;
  if (!s.session) return false;
  if (end_playing()) return true;
  if (s.cover && s.cover->command(*s.session, name)) return s.settle = std::max(s.settle, 1), true;
  if (s.view->command(*s.session, name)) return s.settle = std::max(s.settle, 1), true;
  constexpr std::string_view kTurn = "turn:";
  if (name == "pass_questions") return lesson::pass_questions(*s.session), s.playing = false, true;
  if (name == "reveal_answer") return lesson::reveal_answer(*s.session), s.playing = false, true;
  const int step = s.session->player().step();
  const auto turn = [&](std::string_view part) {
    for (const lesson::Switch& one : s.session->player().switches())
      if (one.name == part) return s.session->player().toggle(one);
    return false;
  };
  const bool done = name.starts_with(kTurn)
                        ? turn(name.substr(kTurn.size()))
                        : s.player(name) || s.edit(name) || s.select(name) || s.look_around(name) || s.move(name);
  if (s.covered() && (s.playing || s.session->player().step() != step))
    s.cover->show(false);  // a step is shown on the stage
  if (done) s.settle = std::max(s.settle, 1);
  if (done && name == "commit_answer") s.decide_by_measuring();
  return done;
}

bool App::pick_choice(int choice) {
  if (!state_->session) return false;
  const bool done = state_->session->conversation().pick(lesson::OneChoice{choice});
  if (done) state_->decide_by_measuring();
  return done;
}

std::string_view App::command_of_key(std::string_view key, bool shift, bool control) const {
  if (state_->session && !control) {
    if (key == "Enter" && state_->session->conversation().picked() != nullptr) return "commit_answer";
    if (state_->sitting && key == "Backspace") return "take_back";
    if (state_->sitting && (key == "h" || key == "H")) return "hint";
    if (state_->sitting && (key == "r" || key == "R")) return "other_run";
    if (key == "Escape" && state_->session->conversation().at_summary()) return "close_summary";
  }
  if (const std::string_view own = state_->cover ? state_->cover->command_of_key(key) : ""; !own.empty() && !control)
    return own;
  const Stage& stage = state_->stage;
  // After a drag the arrows step; with Shift they move what it left selected.
  const bool little = shift && key.starts_with("Arrow") && stage.selected() != kNoIndex && state_->session &&
                      state_->session->conversation().asked() == nullptr &&
                      state_->session->stage().may_move(stage.selected());
  return command_for(key, shift, control, stage.arrows_move() || little);
}

Index App::selected() const { return state_->stage.selected(); }
void App::select(Index point) {
  const bool valid = state_->session && point >= 0 && point < state_->session->stage().subject().size();
  state_->stage.select(valid ? point : kNoIndex);
  state_->settle = std::max(state_->settle, 1);
}
void App::light(std::string_view mark) {
  if (state_->stage.lit() == mark) return;
  state_->stage.light(mark);
  state_->settle = std::max(state_->settle, 1);
}
std::vector<double> App::hand_view() const {
  return state_->session && !state_->covered() ? state_->stage.camera().hand_view() : std::vector<double>();
}
bool App::look_from(const std::vector<double>& view) {
  return state_->session && state_->stage.look_from(*state_->session, view);
}
std::string_view App::lit() const { return state_->stage.lit(); }
std::vector<std::string_view> App::marks_in_hand() const {
  const Index hovered = state_->stage.hovered();
  if (!state_->session || hovered == kNoIndex || hovered >= state_->session->stage().subject().size()) return {};
  return lesson::marks_at(*state_->session, hovered);
}
void App::invite(int followed) {
  state_->invitations = lesson::Invitations(followed);
  state_->invitation.reset();
  state_->invited_handle.clear();
}
int App::invitations_followed() const { return state_->invitations.followed(); }
const std::optional<Invitation>& App::invitation() const { return state_->invitation; }
float App::free_height() const { return static_cast<float>(state_->stage.camera().room()[1]); }
float App::figures_height() const { return state_->figures_height; }
bool App::figures_fill() const { return state_->session && state_->view->fills_column(*state_->session); }
bool App::playing() const { return state_->playing; }
float App::speed() const { return state_->speed; }

void App::pinch(float factor, float x, float y, float dx, float dy) {
  state_->stage.pinch(factor, x, y, dx, dy);
  state_->settle = std::max(state_->settle, 1);
}

void App::frame(const Layout& layout, double now) {
  State& s = *state_;
  whiten(*ImGui::GetIO().Fonts);
  s.settle = has_input(ImGui::GetIO()) ? kSettleFrames : std::max(0, s.settle - 1);
  s.refresh_look(layout.fingers);
  s.look.tools = layout.tools;
  s.look.foot = layout.foot;
  ++s.frames;
  advance(now);
  if (!s.session) return;
  const lesson::WithDecimals wished(s.session->lesson().view.decimals);
  const ImGuiIO& io = ImGui::GetIO();
  const auto any = [](const bool(&of)[5]) { return std::any_of(std::begin(of), std::end(of), std::identity{}); };
  if (any(io.MouseClicked) && end_playing()) s.press_ends = true;
  const auto shows = [](const Rect& rect) { return rect.width >= 1 && rect.height >= 1; };
  // The timeline and the stage change the session; the inspector comes last, with the figures of the same frame.
  if (shows(layout.timeline)) {
    const Pane pane("##timeline", layout.timeline);
    const PlayerWish wish = draw_timeline(s.look, *s.session, *s.view, layout.timeline, {s.playing, s.speed});
    if (!wish.command.empty() && !s.press_ends) command(wish.command);
    if (wish.speed > 0) s.speed = wish.speed;
    s.step_button = wish.step, s.play_button = wish.play;
  }
  if (shows(layout.stage)) {
    const Pane pane("##stage", layout.stage);
    s.draw_stage(layout.stage);
  }
  s.figures_height = 0;
  if (shows(layout.inspector)) {
    if (std::exchange(s.to_top, false)) ImGui::SetNextWindowScroll({0, 0});
    const Pane pane("##inspector", layout.inspector, Pane::Kind::kScrolls);
    s.figures_height = draw_inspector(s.look, *s.session, *s.view, layout.inspector);
    const bool changed = s.session->revision() != s.drawn_revision;
    if (changed && ImGui::GetScrollMaxY() > 0) s.settle = std::max(s.settle, 1);  // it may scroll to the step's row
  }
  if (shows(layout.stage)) s.invite(layout.stage);
  if (!any(io.MouseDown)) s.press_ends = false;
  whiten(*ImGui::GetIO().Fonts);  // the atlas may have grown
  s.drawn_cover = s.cover ? s.cover->version() : 0;
  s.drawn_percent = s.percent();
  s.drawn_revision = s.session->revision();
  s.drawn_settings = s.settings;
}

void App::advance(double now) {
  // A door may draw panels of its own before the frame of this moment.
  if (std::exchange(state_->now, now) != now && state_->look.drawn != nullptr) state_->look.drawn->clear();
  if (!state_->session) return;
  state_->play_on();
  if (state_->sitting) state_->sitting->see(*state_->session);
}

void App::advance_unseen(double now) {
  advance(now);
  if (!state_->session) return;
  state_->view->work(*state_->session);
}

double App::seconds_until_unseen(double now) const {
  return state_->session && state_->view->working() ? 0 : seconds_until_step(now);
}

void App::draw_3d_behind(int framebuffer_width, int framebuffer_height, float scale) {
  if (state_->session && !state_->covered())
    state_->gl.draw(state_->stage.scene(), framebuffer_width, framebuffer_height, scale);
}

bool App::wants_frame(double now) const {
  const State& s = *state_;
  if (s.settle > 0 || !same(s.settings, s.drawn_settings)) return true;
  if (!s.session) return false;
  const bool moving = !s.covered() && s.stage.moving();  // the stage waits while it is covered
  const bool due = (s.playing && now >= s.next_step_at) || moving || s.session->revision() != s.drawn_revision;
  if (due || s.cover == nullptr) return due;
  const bool advanced =
      s.settings.prose_in_canvas && s.percent() != s.drawn_percent;  // the page has its progress bar outside the canvas
  return advanced || s.cover->version() != s.drawn_cover;
}

double App::seconds_until_due(double now) const { return wants_frame(now) ? 0 : seconds_until_step(now); }

double App::seconds_until_step(double now) const {
  if (state_->session && state_->session->conversation().deciding() != nullptr && !state_->playing) return 0;
  return state_->playing ? std::max(0.0, state_->next_step_at - now) : std::numeric_limits<double>::infinity();
}

void App::note_words(std::vector<DrawnWords>* drawn, bool apart) {
  state_->look.drawn = drawn, state_->look.words_apart = apart && drawn != nullptr;
}
long App::frames_drawn() const { return state_->frames; }
std::string App::caption() const {
  if (state_->covered()) return state_->cover->caption(*state_->session);
  return state_->session ? state_->session->telling().caption() : std::string();
}
std::vector<PanelWords> App::panel_words() const {
  if (!state_->session || state_->covered()) return {};
  const lesson::WithDecimals wished(state_->session->lesson().view.decimals);
  return state_->view->panel_words(*state_->session);
}
std::optional<CloseUp> App::close_up() const {
  return state_->session && !state_->covered() ? state_->stage.close_up() : std::nullopt;
}
std::optional<Handle> App::place_named(std::string_view name) const {
  return state_->session && !state_->covered() ? state_->stage.place_named(*state_->session, name) : std::nullopt;
}
const GlScene* App::scene() const { return state_->session && !state_->covered() ? &state_->stage.scene() : nullptr; }
std::vector<Handle> App::handles() const {
  if (state_->covered()) return state_->cover->handles();
  return state_->session ? state_->stage.handles(*state_->session) : std::vector<Handle>{};
}

}  // namespace snug::app
