/// What this SDK says of itself.
#ifndef URBI_PACKAGE_INFO_HH
#define URBI_PACKAGE_INFO_HH

#include <libport/package-info.hh>

#include <urbi/export.hh>
#include <urbi/revision.hh>

namespace urbi
{
  inline libport::PackageInfo package_info()
  {
    libport::PackageInfo::data_type all;
    all["name"] = "Urbi SDK";
    all["version"] = URBI_SDK_VERSION;
    all["revision"] = URBI_SDK_REVISION;
    all["bug-report"] = "those who maintain this installation";
    return libport::PackageInfo(all);
  }
}

#endif
