/// The version of the kernel, as components know it.
#ifndef URBI_KERNEL_VERSION_HH
#define URBI_KERNEL_VERSION_HH

#include <string>

#include <urbi/detail/host.hh>
#include <urbi/export.hh>

namespace urbi
{
  inline int kernelMajor()
  {
    return detail::KERNEL_MAJOR;
  }

  inline int kernelMinor()
  {
    return detail::KERNEL_MINOR;
  }

  inline std::string kernelVersion()
  {
    return std::to_string(kernelMajor()) + "." + std::to_string(kernelMinor());
  }
}

#endif
