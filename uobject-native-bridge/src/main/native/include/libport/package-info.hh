/// What a package is, and its version.
#ifndef LIBPORT_PACKAGE_INFO_HH
#define LIBPORT_PACKAGE_INFO_HH

#include <map>
#include <ostream>
#include <string>

#include <libport/compiler.hh>

namespace libport
{
  /// What a package says of itself: values by name.
  class PackageInfo
  {
  public:
    typedef std::map<std::string, std::string> data_type;

    PackageInfo() = default;

    explicit PackageInfo(const data_type& data)
      : data_(data)
    {}

    /// The value of that name, or nothing.
    std::string get(const std::string& name) const
    {
      data_type::const_iterator found = data_.find(name);
      return found == data_.end() ? std::string() : found->second;
    }

    /// Name and version.
    std::string signature() const
    {
      return get("name") + " version " + get("version");
    }

    /// Where to tell of errors.
    std::string report_bugs() const
    {
      return "Report bugs to " + get("bug-report") + ".";
    }

    const data_type& data() const
    {
      return data_;
    }

  private:
    data_type data_;
  };

  inline std::ostream& operator<<(std::ostream& out, const PackageInfo& info)
  {
    return out << info.signature();
  }
}

#endif
