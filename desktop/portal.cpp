#include "desktop/portal.hpp"

#include <dlfcn.h>

#include <cstdint>
#include <filesystem>

namespace snug::desktop {
namespace {

// What is called of libportal and GLib, by their documented interfaces: their headers are not needed to build.
struct GError {
  std::uint32_t domain;
  int code;
  char* message;
};
using Ready = void (*)(void* source, void* result, void* data);
constexpr int kCancelledCode = 19;  // G_IO_ERROR_CANCELLED

struct Library {
  void* (*portal_new)(GError** error);
  void (*open_file)(void* portal, void* parent, const char* title, void* filters, void* current, void* choices,
                    int flags, void* cancellable, Ready ready, void* data);
  void* (*open_finish)(void* portal, void* result, GError** error);
  void (*save_file)(void* portal, void* parent, const char* title, const char* name, const char* folder,
                    const char* file, void* filters, void* current, void* choices, int flags, void* cancellable,
                    Ready ready, void* data);
  void* (*save_finish)(void* portal, void* result, GError** error);
  void* (*variant_new_parsed)(const char* text, ...);
  int (*variant_lookup)(void* variant, const char* key, const char* format, ...);
  char* (*filename_from_uri)(const char* uri, char** host, GError** error);
  int (*iterate)(void* context, int may_block);
  bool complete = false;
};

const Library& library() {
  static const Library loaded = [] {
    Library all{};
    void* const handle = dlopen("libportal.so.1", RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) return all;
    all.complete = true;
    const auto take = [&](auto& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, name));
      all.complete = all.complete && function != nullptr;
    };
    take(all.portal_new, "xdp_portal_initable_new");
    take(all.open_file, "xdp_portal_open_file"), take(all.open_finish, "xdp_portal_open_file_finish");
    take(all.save_file, "xdp_portal_save_file"), take(all.save_finish, "xdp_portal_save_file_finish");
    take(all.variant_new_parsed, "g_variant_new_parsed"), take(all.variant_lookup, "g_variant_lookup");
    take(all.filename_from_uri, "g_filename_from_uri"), take(all.iterate, "g_main_context_iteration");
    return all;
  }();
  return loaded;
}

void* portal = nullptr;
PortalAnswer answered;
bool saving = false;

void take_answer(void*, void* result, void*) {
  GError* error = nullptr;
  void* const chosen = (saving ? library().save_finish : library().open_finish)(portal, result, &error);
  using Kind = PortalAnswer::Kind;
  if (chosen == nullptr) {
    answered.kind = error != nullptr && error->code == kCancelledCode ? Kind::kCancelled : Kind::kNone;
    return;
  }
  answered.kind = Kind::kCancelled;
  char** uris = nullptr;
  if (library().variant_lookup(chosen, "uris", "^a&s", &uris) == 0 || uris == nullptr || uris[0] == nullptr) return;
  if (const char* const path = library().filename_from_uri(uris[0], nullptr, nullptr); path != nullptr)
    answered = {Kind::kChosen, path};
}

}  // namespace

bool open_portal(const char* title, const std::vector<std::string>& endings, bool saves, const std::string& proposed) {
  const Library& calls = library();
  if (!calls.complete) return false;
  if (portal == nullptr) {
    GError* error = nullptr;
    portal = calls.portal_new(&error);
  }
  if (portal == nullptr) return false;
  std::string filters = "[('Files', [";
  for (const std::string& ending : endings) filters += "(uint32 0, '*." + ending + "'),";
  filters.back() = ']';
  void* const shown = calls.variant_new_parsed((filters + ")]").c_str());
  answered = {};
  saving = saves;
  const std::filesystem::path path(proposed);
  if (saves)
    calls.save_file(portal, nullptr, title, path.filename().c_str(), path.parent_path().c_str(), nullptr, shown,
                    nullptr, nullptr, 0, nullptr, take_answer, nullptr);
  else calls.open_file(portal, nullptr, title, shown, nullptr, nullptr, 0, nullptr, take_answer, nullptr);
  return true;
}

PortalAnswer portal_answer() {
  if (!library().complete) return {PortalAnswer::Kind::kNone, {}};
  while (answered.kind == PortalAnswer::Kind::kWaits && library().iterate(nullptr, 0) != 0) {
  }
  return answered;
}

}  // namespace snug::desktop
