/// Whether a component fits to the kernel that loads it.
#ifndef URBI_VERSION_CHECK_HH
#define URBI_VERSION_CHECK_HH

#include <string>

#include <libport/debug.hh>
#include <libport/package-info.hh>
#include <libport/preproc.hh>

#include <urbi/package-info.hh>
#include <urbi/revision.hh>

namespace urbi
{
  /// Nothing to do: whoever loads a module compares the versions of the boundary first.
  inline int check_sdk_version(const std::string& = "", const std::string& = URBI_SDK_VERSION,
                               const std::string& = URBI_SDK_REVISION)
  {
    return 0;
  }

  inline void check_sdk_version_once(const std::string& where = "")
  {
    check_sdk_version(where);
  }

  class VersionChecker
  {
  public:
    explicit VersionChecker(const std::string& where = "",
                            const std::string& version = URBI_SDK_VERSION,
                            const std::string& revision = URBI_SDK_REVISION)
    {
      check_sdk_version(where, version, revision);
    }
  };
}

#define URBI_CHECK_SDK_VERSION(Where) ::urbi::check_sdk_version(Where)
#define URBI_CHECK_SDK_VERSION_BARE(Where)                                                        \
  static const ::urbi::VersionChecker LIBPORT_CAT(urbi_checked_, __LINE__)(Where)

#endif
