/// What urbi/uvalue.hh and urbi/ulist.hh declare, and the casters.
// Before anything else: that header includes this one where it needs it.
#include <urbi/uvalue.hh>

#ifndef URBI_UVALUE_HXX
#define URBI_UVALUE_HXX

#include <cmath>
#include <cstring>
#include <map>
#include <sstream>

#include <urbi/detail/literal.hh>

namespace urbi
{
  // ---------------------------------------------------------------- UList

  inline UList::UList()
    : offset(0)
  {}

  inline UList::UList(const UList& other)
    : offset(0)
  {
    *this = other;
  }

  inline UList::UList(UList&& other) noexcept
    : array(std::move(other.array))
    , offset(other.offset)
  {
    other.array.clear();
  }

  inline UList::~UList()
  {
    clear();
  }

  inline UList& UList::operator=(const UList& other)
  {
    if (this != &other)
    {
      clear();
      array.reserve(other.array.size());
      for (const UValue* element : other.array)
        array.push_back(new UValue(*element));
      offset = other.offset;
    }
    return *this;
  }

  inline UList& UList::operator=(UList&& other) noexcept
  {
    if (this != &other)
    {
      array.swap(other.array);
      std::swap(offset, other.offset);
    }
    return *this;
  }

  template <typename T>
  UList& UList::operator=(const T& container)
  {
    UList made;
    for (const auto& element : container)
      made.push_back(element);
    return *this = std::move(made);
  }

  template <typename T>
  T UList::as() const
  {
    UValue all(*this);
    return uvalue_cast<T>(all);
  }

  inline UList::iterator UList::begin()
  {
    return array.begin() + static_cast<std::ptrdiff_t>(offset);
  }

  inline UList::iterator UList::end()
  {
    return array.end();
  }

  inline UList::const_iterator UList::begin() const
  {
    return array.begin() + static_cast<std::ptrdiff_t>(offset);
  }

  inline UList::const_iterator UList::end() const
  {
    return array.end();
  }

  template <typename T>
  UList& UList::push_back(const T& element)
  {
    array.reserve(array.size() + 1);
    UValue made;
    made = element;
    array.push_back(new UValue(std::move(made)));
    return *this;
  }

  inline void UList::pop_back()
  {
    delete array.back();
    array.pop_back();
  }

  inline UValue& UList::front()
  {
    return (*this)[0];
  }

  inline UValue& UList::operator[](size_t i)
  {
    return *array.at(i + offset);
  }

  inline const UValue& UList::operator[](size_t i) const
  {
    return *array.at(i + offset);
  }

  inline size_t UList::size() const
  {
    return array.size() - offset;
  }

  inline void UList::setOffset(size_t n)
  {
    offset = n < array.size() ? n : array.size();
  }

  inline std::ostream& UList::print(std::ostream& out) const
  {
    out << "[";
    for (size_t i = 0; i < size(); ++i)
      (*this)[i].print(out << (i ? ", " : ""));
    return out << "]";
  }

  inline void UList::clear()
  {
    for (UValue* element : array)
      delete element;
    array.clear();
    offset = 0;
  }

  inline std::ostream& operator<<(std::ostream& out, const UList& list)
  {
    return list.print(out);
  }

  // ---------------------------------------------------------------- errors

  namespace detail
  {
    /// The value as an urbiscript literal.
    inline std::string literal_of(const UValue& value)
    {
      std::ostringstream out;
      value.print(out);
      return out.str();
    }

    /// What is shown of a value in a message.
    inline std::string brief(const UValue& value)
    {
      const size_t longest = 60;
      if (value.type == DATA_BINARY)
        return "BIN " + number_text(static_cast<ufloat>(value.binary->common.size)) + " "
          + value.binary->getMessage();
      std::string text = literal_of(value);
      return text.size() <= longest ? text : text.substr(0, longest) + "...";
    }

    /// The type of whole numbers, for people.
    template <typename T>
    std::string integer_name()
    {
      return (std::is_signed<T>::value ? "int" : "unsigned int") + std::to_string(8 * sizeof(T));
    }

    [[noreturn]] inline void bad_cast(const char* type, const UValue& value)
    {
      throw std::runtime_error(std::string("invalid cast to ") + type + " from "
                               + (value.type == DATA_VOID ? "void" : brief(value)));
    }
  }

  // ---------------------------------------------------------------- UValue

  inline UValue::UValue()
    : type(DATA_VOID)
    , val(0)
    , storage(nullptr)
  {}

  inline UValue::UValue(const UValue& other)
    : UValue()
  {
    set(other);
  }

  inline UValue::UValue(UValue&& other) noexcept
    : UValue()
  {
    steal(other);
  }

  inline UValue::~UValue()
  {
    clear();
  }

  template <typename T, UValue::if_number<T>>
  UValue::UValue(T number, bool)
    : type(DATA_DOUBLE)
    , val(static_cast<ufloat>(number))
    , storage(nullptr)
  {}

  inline UValue::UValue(const char* text, bool)
    : UValue()
  {
    stringValue = new std::string(text ? text : "");
    type = DATA_STRING;
  }

  inline UValue::UValue(const std::string& text, bool)
    : UValue()
  {
    stringValue = new std::string(text);
    type = DATA_STRING;
  }

  inline UValue::UValue(const void* text, bool)
    : UValue(static_cast<const char*>(text))
  {}

  inline UValue::UValue(const UBinary& other, bool copy)
    : UValue()
  {
    binary = new UBinary(other, copy);
    type = DATA_BINARY;
  }

  inline UValue::UValue(const UImage& image, bool copy)
    : UValue()
  {
    binary = new UBinary(image, copy);
    type = DATA_BINARY;
  }

  inline UValue::UValue(const USound& sound, bool copy)
    : UValue()
  {
    binary = new UBinary(sound, copy);
    type = DATA_BINARY;
  }

  inline UValue::UValue(const UList& other, bool)
    : UValue()
  {
    list = new UList(other);
    type = DATA_LIST;
  }

  inline UValue::UValue(const UDictionary& other, bool)
    : UValue()
  {
    dictionary = new UDictionary(other);
    type = DATA_DICTIONARY;
  }

  inline UValue& UValue::operator=(const UValue& other)
  {
    return set(other);
  }

  inline UValue& UValue::operator=(UValue&& other) noexcept
  {
    if (this != &other)
    {
      clear();
      steal(other);
    }
    return *this;
  }

  inline void UValue::steal(UValue& other) noexcept
  {
    type = other.type;
    val = other.val;
    storage = other.storage;
    other.type = DATA_VOID;
    other.storage = nullptr;
  }

  inline UValue& UValue::set(const UValue& other, bool copied)
  {
    if (this == &other)
      return *this;
    UValue made;
    switch (other.type)
    {
    case DATA_BINARY: made.binary = new UBinary(*other.binary, copied); break;
    case DATA_DICTIONARY: made.dictionary = new UDictionary(*other.dictionary); break;
    case DATA_LIST: made.list = new UList(*other.list); break;
    case DATA_STRING:
    case DATA_SLOTNAME: made.stringValue = new std::string(*other.stringValue); break;
    case DATA_DOUBLE: made.val = other.val; break;
    case DATA_VOID: break;
    }
    made.type = other.type;
    return *this = std::move(made);
  }

  inline void UValue::clear()
  {
    switch (type)
    {
    case DATA_BINARY: delete binary; break;
    case DATA_DICTIONARY: delete dictionary; break;
    case DATA_LIST: delete list; break;
    case DATA_STRING:
    case DATA_SLOTNAME: delete stringValue; break;
    case DATA_DOUBLE:
    case DATA_VOID: break;
    }
    type = DATA_VOID;
    storage = nullptr;
  }

  inline const char* UValue::format_string() const
  {
    switch (type)
    {
    case DATA_BINARY: return "binary";
    case DATA_DICTIONARY: return "dictionary";
    case DATA_DOUBLE: return "double";
    case DATA_LIST: return "list";
    case DATA_STRING: return "string";
    case DATA_SLOTNAME: return "slotname";
    case DATA_VOID: return "void";
    }
    return "";
  }

  inline ufloat UValue::number() const
  {
    if (type == DATA_DOUBLE)
      return val;
    if (type == DATA_STRING)
    {
      UValue read;
      if (detail::read_literal(*stringValue, read) && read.type == DATA_DOUBLE)
        return read.val;
    }
    detail::bad_cast("double", *this);
  }

  namespace detail
  {
    /// A number in another type, without its decimals.
    ///
    /// \throw std::runtime_error if it is too large or too small for that
    template <typename T>
    T to_number(ufloat value)
    {
      if constexpr (std::is_same<T, bool>::value)
        return value != 0;
      else if constexpr (std::is_floating_point<T>::value)
        return static_cast<T>(value);
      else
      {
        // The largest number may be none of the doubles: the one above it is.
        typedef std::numeric_limits<T> limits;
        ufloat whole = std::trunc(value);
        if (!(whole >= static_cast<ufloat>(limits::min())
              && whole < std::ldexp(ufloat(1), limits::digits)))
          throw std::runtime_error("invalid cast to " + integer_name<T>() + " from "
                                   + number_text(value) + ": out of range");
        return static_cast<T>(whole);
      }
    }
  }

  template <typename T, UValue::if_number<T>>
  UValue::operator T() const
  {
    return detail::to_number<T>(number());
  }

  inline UValue::operator std::string() const
  {
    switch (type)
    {
    case DATA_STRING:
    case DATA_SLOTNAME: return *stringValue;
    case DATA_DOUBLE: return detail::number_text(val);
    default: detail::bad_cast("string", *this);
    }
  }

  inline UValue::operator const UBinary&() const
  {
    if (type != DATA_BINARY)
      detail::bad_cast("UBinary", *this);
    return *binary;
  }

  inline UValue& UValue::error()
  {
    static UValue none;
    none.clear();
    return none;
  }

  inline UNamedValue& UNamedValue::error()
  {
    static UNamedValue none;
    return none;
  }

  inline UValue::operator UList() const
  {
    if (type != DATA_LIST)
      detail::bad_cast("UList", *this);
    return *list;
  }

  inline UValue::operator UDictionary() const
  {
    if (type != DATA_DICTIONARY)
      detail::bad_cast("UDictionary", *this);
    return *dictionary;
  }

  inline UValue::operator UImage() const
  {
    if (type != DATA_BINARY)
      detail::bad_cast("UImage", *this);
    return binary->type == BINARY_IMAGE ? UImage(binary->image) : UImage();
  }

  inline UValue::operator USound() const
  {
    if (type != DATA_BINARY)
      detail::bad_cast("USound", *this);
    return binary->type == BINARY_SOUND ? USound(binary->sound) : USound();
  }

  inline int UValue::parse(const char* message, int pos, const binaries_type& bins,
                           binaries_type::const_iterator& binpos)
  {
    detail::LiteralReader reader(message, message + std::strlen(message), &bins, &binpos);
    reader.seek(pos);
    UValue read;
    if (!reader.value(read))
      return -reader.position();
    *this = std::move(read);
    return reader.position();
  }

  inline std::ostream& UValue::print(std::ostream& out) const
  {
    switch (type)
    {
    case DATA_BINARY: return binary->print(out);
    case DATA_DICTIONARY: return out << *dictionary;
    case DATA_LIST: return list->print(out);
    case DATA_DOUBLE: return out << detail::number_text(val);
    case DATA_STRING: return out << detail::quoted(*stringValue);
    case DATA_SLOTNAME: return out << *stringValue;
    case DATA_VOID: break;
    }
    return out << "void";
  }

  inline std::ostream& operator<<(std::ostream& out, const UValue& value)
  {
    return value.print(out);
  }

  inline std::ostream& operator<<(std::ostream& out, const UDictionary& dictionary)
  {
    if (dictionary.empty())
      return out << "[ => ]";
    // In a reproducible order.
    std::map<std::string, const UValue*> sorted;
    for (const auto& entry : dictionary)
      sorted.insert(std::make_pair(entry.first, &entry.second));
    const char* separator = "[";
    for (const auto& entry : sorted)
    {
      entry.second->print(out << separator << detail::quoted(entry.first) << " => ");
      separator = ", ";
    }
    return out << "]";
  }
}

#include <urbi/detail/casters.hh>

#endif
