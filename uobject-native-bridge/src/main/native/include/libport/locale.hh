/// What numbers and texts look like in a country.
#ifndef LIBPORT_LOCALE_HH
#define LIBPORT_LOCALE_HH

#include <clocale>
#include <stdexcept>
#include <string>

namespace libport
{
  /// The number of a category that is given by its name, `LC_...`.
  inline int locale_category(const std::string& name)
  {
    static const struct
    {
      const char* name;
      int number;
    } all[] = {{"LC_ALL", LC_ALL},           {"LC_COLLATE", LC_COLLATE}, {"LC_CTYPE", LC_CTYPE},
               {"LC_MONETARY", LC_MONETARY}, {"LC_NUMERIC", LC_NUMERIC}, {"LC_TIME", LC_TIME}};
    for (const auto& each : all)
      if (name == each.name)
        return each.number;
    throw std::runtime_error("invalid locale category: " + name);
  }

  /// Sets the locale of a category; null leaves it. \return what it is now
  inline std::string setlocale(const std::string& category, const char* locale)
  {
    const char* now = std::setlocale(locale_category(category), locale);
    if (!now)
      throw std::runtime_error("cannot set locale " + category + " to " + locale);
    return now;
  }

  inline std::string setlocale(const std::string& category, const std::string& locale)
  {
    return setlocale(category, locale.c_str());
  }
}

#endif
