// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "pictures/gl_context.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "kinematics/words.h"
#include "text/input_error.h"

// Declares only types: the functions come from the library that is opened, and X11 is not used.
#define EGL_EGL_PROTOTYPES 0
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace girdle {
namespace {

// Platforms that make an OpenGL context without a screen, in the order in which they are tried.
enum class GlPlatform {
  kEglDevice,
  kEglSurfaceless,
  kOsMesa,
};
// Names for people, in the order of the enumerators.
constexpr std::array<std::string_view, 3> kPlatformNames = {"EGL device", "EGL surfaceless",
                                                            "OSMesa"};
constexpr const auto& WordsOf(GlPlatform /*which*/) noexcept { return kPlatformNames; }

}  // namespace

/// The OpenGL of one library: makes contexts and finds functions.
class GlLibrary {
 public:
  GlLibrary() = default;
  GlLibrary(const GlLibrary&) = delete;
  GlLibrary& operator=(const GlLibrary&) = delete;
  virtual ~GlLibrary() = default;

  [[nodiscard]] virtual GlPlatform platform() const noexcept = 0;
  /// Returns a context, or null.
  [[nodiscard]] virtual void* Create() = 0;
  /// Makes a context current, or none if `context` is null. Returns whether this succeeded.
  [[nodiscard]] virtual bool MakeCurrent(void* context) noexcept = 0;
  virtual void Destroy(void* context) noexcept = 0;
  /// Returns an OpenGL function, or null.
  [[nodiscard]] virtual void* Function(const char* name) noexcept = 0;
};

namespace {

constexpr const char* kInstall =
    "apt-get install libegl1 libgl1-mesa-dri, or: apt-get install libosmesa6";

// A library that the destructor closes unless Keep was called.
class SharedLibrary {
 public:
  // Opens the first of `names` that can be opened.
  explicit SharedLibrary(const std::vector<const char*>& names) {
    for (const char* name : names) {
      handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
      if (handle_ != nullptr) {
        name_ = name;
        return;
      }
      reason_ = dlerror();
    }
  }
  SharedLibrary(SharedLibrary&& other) noexcept
      : handle_(std::exchange(other.handle_, nullptr)),
        is_kept_(other.is_kept_),
        name_(other.name_),
        reason_(std::move(other.reason_)) {}
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;
  SharedLibrary& operator=(SharedLibrary&&) = delete;
  ~SharedLibrary() {
    if (handle_ != nullptr && !is_kept_) {
      dlclose(handle_);
    }
  }

  [[nodiscard]] bool is_open() const noexcept { return handle_ != nullptr; }
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

  template <typename Function>
  [[nodiscard]] Function Find(const char* name) const noexcept {
    return reinterpret_cast<Function>(dlsym(handle_, name));
  }

  // Keeps the library open for good. Call this before any of its functions: they may start threads
  // even if they fail, and a library with threads cannot be closed.
  void Keep() noexcept { is_kept_ = true; }

  // Makes the library's functions the ones that MuJoCo finds.
  void Publish() const { dlopen(name_, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD); }

 private:
  void* handle_ = nullptr;
  bool is_kept_ = false;
  const char* name_ = "";
  std::string reason_;
};

// Whether a list of extensions, separated by spaces, has a certain one.
bool Lists(const char* extensions, std::string_view name) {
  return extensions != nullptr &&
         (" " + std::string(extensions) + " ").find(" " + std::string(name) + " ") !=
             std::string::npos;
}

struct EglFunctions {
  explicit EglFunctions(const SharedLibrary& library)
      : get_function(library.Find<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress")),
        query_string(library.Find<PFNEGLQUERYSTRINGPROC>("eglQueryString")),
        initialize(library.Find<PFNEGLINITIALIZEPROC>("eglInitialize")),
        terminate(library.Find<PFNEGLTERMINATEPROC>("eglTerminate")),
        bind_api(library.Find<PFNEGLBINDAPIPROC>("eglBindAPI")),
        choose_config(library.Find<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig")),
        create_context(library.Find<PFNEGLCREATECONTEXTPROC>("eglCreateContext")),
        destroy_context(library.Find<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")),
        make_current(library.Find<PFNEGLMAKECURRENTPROC>("eglMakeCurrent")) {
    if (get_function != nullptr) {
      get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
          get_function("eglGetPlatformDisplayEXT"));
      query_devices =
          reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(get_function("eglQueryDevicesEXT"));
    }
  }

  [[nodiscard]] bool complete() const noexcept {
    return query_string != nullptr && initialize != nullptr && terminate != nullptr &&
           bind_api != nullptr && choose_config != nullptr && create_context != nullptr &&
           destroy_context != nullptr && make_current != nullptr && get_platform_display != nullptr;
  }

  PFNEGLGETPROCADDRESSPROC get_function;
  PFNEGLQUERYSTRINGPROC query_string;
  PFNEGLINITIALIZEPROC initialize;
  PFNEGLTERMINATEPROC terminate;
  PFNEGLBINDAPIPROC bind_api;
  PFNEGLCHOOSECONFIGPROC choose_config;
  PFNEGLCREATECONTEXTPROC create_context;
  PFNEGLDESTROYCONTEXTPROC destroy_context;
  PFNEGLMAKECURRENTPROC make_current;
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;
  PFNEGLQUERYDEVICESEXTPROC query_devices = nullptr;  ///< null where there are no devices
};

class EglLibrary : public GlLibrary {
 public:
  EglLibrary(const EglFunctions& egl, GlPlatform platform, EGLDisplay display, EGLConfig config)
      : egl_(egl), platform_(platform), display_(display), config_(config) {}

  [[nodiscard]] GlPlatform platform() const noexcept override { return platform_; }

  // Makes a context of OpenGL's compatibility profile, which MuJoCo needs and which is the default.
  [[nodiscard]] void* Create() override {
    return egl_.bind_api(EGL_OPENGL_API) == EGL_FALSE
               ? nullptr
               : egl_.create_context(display_, config_, EGL_NO_CONTEXT, nullptr);
  }
  [[nodiscard]] bool MakeCurrent(void* context) noexcept override {
    return egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_FALSE;
  }
  void Destroy(void* context) noexcept override { egl_.destroy_context(display_, context); }
  [[nodiscard]] void* Function(const char* name) noexcept override {
    return reinterpret_cast<void*>(egl_.get_function(name));
  }

 private:
  EglFunctions egl_;
  GlPlatform platform_;
  EGLDisplay display_;
  EGLConfig config_;
};

// Whether a context of the library can be made and used.
bool Works(GlLibrary& library) {
  void* const context = library.Create();
  if (context == nullptr) {
    return false;
  }
  const bool works = library.MakeCurrent(context);
  static_cast<void>(library.MakeCurrent(nullptr));
  library.Destroy(context);
  return works;
}

// Returns EGL on one display, or null.
std::unique_ptr<GlLibrary> EglOn(const EglFunctions& egl, GlPlatform platform, EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || egl.initialize(display, nullptr, nullptr) == EGL_FALSE) {
    return nullptr;
  }
  constexpr std::array<EGLint, 5> kAttributes = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
                                                 EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (egl.bind_api(EGL_OPENGL_API) != EGL_FALSE &&
      egl.choose_config(display, kAttributes.data(), &config, 1, &count) != EGL_FALSE &&
      count > 0) {
    auto library = std::make_unique<EglLibrary>(egl, platform, display, config);
    if (Works(*library)) {
      return library;
    }
  }
  egl.terminate(display);
  return nullptr;
}

std::unique_ptr<GlLibrary> OpenEgl(std::string& problems) {
  SharedLibrary library({"libEGL.so.1"});
  if (!library.is_open()) {
    problems += "EGL: " + library.reason();
    return nullptr;
  }
  // EGL must not print that it finds no device: it continues without one.
  setenv("EGL_LOG_LEVEL", "fatal", 0);
  library.Keep();
  const EglFunctions egl(library);
  if (!egl.complete()) {
    problems += "EGL: libEGL.so.1 lacks functions";
    return nullptr;
  }
  const char* const extensions = egl.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::unique_ptr<GlLibrary> found;
  if (Lists(extensions, "EGL_EXT_platform_device") && egl.query_devices != nullptr) {
    constexpr EGLint kMostDevices = 32;
    std::array<EGLDeviceEXT, kMostDevices> devices{};
    EGLint count = 0;
    if (egl.query_devices(kMostDevices, devices.data(), &count) != EGL_FALSE) {
      for (EGLint i = 0; i < count && found == nullptr; ++i) {
        found = EglOn(egl, GlPlatform::kEglDevice,
                      egl.get_platform_display(EGL_PLATFORM_DEVICE_EXT,
                                               devices[static_cast<std::size_t>(i)], nullptr));
      }
    }
  }
  if (found == nullptr && Lists(extensions, "EGL_MESA_platform_surfaceless")) {
    found = EglOn(
        egl, GlPlatform::kEglSurfaceless,
        egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  if (found == nullptr) {
    problems += "EGL: neither a device nor the surfaceless platform has OpenGL";
    return nullptr;
  }
  library.Publish();
  return found;
}

// The functions and numbers of Mesa's off-screen interface that are needed, which have been stable
// since 1998. Its header would include all of OpenGL's.
using OsMesaCreateFunction = void* (*)(unsigned format, int depth_bits, int stencil_bits,
                                       int accumulation_bits, void* shared);
using OsMesaMakeCurrentFunction = unsigned char (*)(void* context, void* buffer, unsigned type,
                                                    int width, int height);
using OsMesaDestroyFunction = void (*)(void* context);
using OsMesaFunctionFunction = void* (*)(const char* name);
constexpr unsigned kOsMesaRgba = 0x1908;
constexpr unsigned kOsMesaUnsignedByte = 0x1401;

class OsMesaLibrary : public GlLibrary {
 public:
  explicit OsMesaLibrary(const SharedLibrary& library)
      : create_(library.Find<OsMesaCreateFunction>("OSMesaCreateContextExt")),
        make_current_(library.Find<OsMesaMakeCurrentFunction>("OSMesaMakeCurrent")),
        destroy_(library.Find<OsMesaDestroyFunction>("OSMesaDestroyContext")),
        function_(library.Find<OsMesaFunctionFunction>("OSMesaGetProcAddress")) {}

  [[nodiscard]] bool complete() const noexcept {
    return create_ != nullptr && make_current_ != nullptr && destroy_ != nullptr &&
           function_ != nullptr;
  }

  [[nodiscard]] GlPlatform platform() const noexcept override { return GlPlatform::kOsMesa; }
  [[nodiscard]] void* Create() override {
    constexpr int kDepthBits = 24;
    constexpr int kStencilBits = 8;
    return create_(kOsMesaRgba, kDepthBits, kStencilBits, 0, nullptr);
  }
  [[nodiscard]] bool MakeCurrent(void* context) noexcept override {
    return context == nullptr
               ? make_current_(nullptr, nullptr, 0, 0, 0) != 0
               : make_current_(context, unused_.data(), kOsMesaUnsignedByte, kSide, kSide) != 0;
  }
  void Destroy(void* context) noexcept override { destroy_(context); }
  [[nodiscard]] void* Function(const char* name) noexcept override { return function_(name); }

 private:
  OsMesaCreateFunction create_;
  OsMesaMakeCurrentFunction make_current_;
  OsMesaDestroyFunction destroy_;
  OsMesaFunctionFunction function_;
  // A context must have a buffer. It stays unused, because MuJoCo draws to buffers of its own.
  static constexpr int kSide = 16;
  std::array<unsigned char, static_cast<std::size_t>(4) * kSide * kSide> unused_{};
};

std::unique_ptr<GlLibrary> OpenOsMesa(std::string& problems) {
  problems += problems.empty() ? "" : "; ";
  SharedLibrary shared({"libOSMesa.so.6", "libOSMesa.so.8"});
  if (!shared.is_open()) {
    problems += "OSMesa: " + shared.reason();
    return nullptr;
  }
  auto library = std::make_unique<OsMesaLibrary>(shared);
  if (!library->complete()) {
    problems += "OSMesa: it lacks functions";
    return nullptr;
  }
  shared.Keep();
  if (!Works(*library)) {
    problems += "OSMesa: it makes no context";
    return nullptr;
  }
  shared.Publish();
  return library;
}

std::unique_ptr<GlLibrary> OpenLibrary() {
  const char* const set = std::getenv(kGlVariable);
  const std::string word = set == nullptr ? "" : set;
  if (!word.empty() && std::find(kGlWords.begin(), kGlWords.end(), word) == kGlWords.end()) {
    throw InputError(std::string(kGlVariable) + "=" + word +
                     ": not known. Set it to egl, osmesa or none, or unset it");
  }
  const std::string chosen = word.empty() ? "" : std::string(kGlVariable) + "=" + word + ", ";
  if (word == "none") {
    throw InputError("cannot draw pictures: " + std::string(kGlVariable) +
                     "=none. Unset it. If nothing draws then: " + kInstall);
  }
  std::string problems;
  std::unique_ptr<GlLibrary> library;
  if (word != "osmesa") {
    library = OpenEgl(problems);
  }
  if (library == nullptr && word != "egl") {
    library = OpenOsMesa(problems);
  }
  if (library == nullptr) {
    throw InputError("cannot draw pictures: no OpenGL that draws without a screen (" + chosen +
                     problems + "). Install one: " + kInstall);
  }
  return library;
}

// Returns the library of this process. It and its displays live until the process ends.
GlLibrary& Library() {
  static GlLibrary* const kLibrary = OpenLibrary().release();
  return *kLibrary;
}

}  // namespace

GlContext::GlContext() : library_(Library()), context_(library_.Create()) {
  if (context_ == nullptr || !library_.MakeCurrent(context_)) {
    if (context_ != nullptr) {
      library_.Destroy(context_);
    }
    throw InputError("cannot draw pictures: OpenGL gives no further context. Draw fewer at a time");
  }
}

GlContext::~GlContext() {
  static_cast<void>(library_.MakeCurrent(nullptr));
  library_.Destroy(context_);
}

bool GlContext::MakeCurrent() const noexcept { return library_.MakeCurrent(context_); }

std::string GlContext::Description() const {
  constexpr unsigned kRenderer = 0x1F01;  // GL_RENDERER
  using GetString = const unsigned char* (*)(unsigned);
  const auto get_string = reinterpret_cast<GetString>(library_.Function("glGetString"));
  const unsigned char* const renderer =
      MakeCurrent() && get_string != nullptr ? get_string(kRenderer) : nullptr;
  return std::string(Name(library_.platform())) +
         (renderer == nullptr ? "" : ", " + std::string(reinterpret_cast<const char*>(renderer)));
}

}  // namespace girdle
