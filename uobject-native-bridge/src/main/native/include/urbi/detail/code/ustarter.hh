/// What urbi/ustarter.hh declares: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/ustarter.hh>

#ifndef URBI_DETAIL_CODE_USTARTER_HH
#define URBI_DETAIL_CODE_USTARTER_HH

namespace urbi
{
  URBI_INLINE baseURBIStarter::baseURBIStarter(const std::string& className, bool isLocal)
    : name(className)
    , local(isLocal)
  {
    list().push_back(this);
  }

  URBI_INLINE baseURBIStarter::~baseURBIStarter()
  {
    list().remove(this);
  }

  URBI_INLINE baseURBIStarter::list_type& baseURBIStarter::list()
  {
    return detail::module().starters;
  }

  URBI_INLINE baseURBIStarterHub::baseURBIStarterHub(const std::string& className)
    : name(className)
  {
    list().push_back(this);
  }

  URBI_INLINE baseURBIStarterHub::~baseURBIStarterHub()
  {
    list().remove(this);
  }

  URBI_INLINE baseURBIStarterHub::list_type& baseURBIStarterHub::list()
  {
    return detail::module().hubStarters;
  }
}

#endif
