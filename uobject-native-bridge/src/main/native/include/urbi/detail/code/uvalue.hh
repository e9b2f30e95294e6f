/// What urbi/uvalue.hh and urbi/ulist.hh declare: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/uvalue.hh>

#ifndef URBI_DETAIL_CODE_UVALUE_HH
#define URBI_DETAIL_CODE_UVALUE_HH

namespace urbi
{
  namespace detail
  {
    URBI_INLINE std::string literal_of(const UValue& value)
    {
      std::ostringstream out;
      value.print(out);
      return out.str();
    }

    URBI_INLINE std::string brief(const UValue& value)
    {
      const size_t longest = 60;
      if (value.type == DATA_BINARY)
        return "BIN " + number_text(static_cast<ufloat>(value.binary->common.size)) + " "
          + value.binary->getMessage();
      std::string text = literal_of(value);
      return text.size() <= longest ? text : text.substr(0, longest) + "...";
    }

    [[noreturn]] URBI_INLINE void bad_cast(const char* type, const UValue& value)
    {
      throw std::runtime_error(std::string("invalid cast to ") + type + " from "
                               + (value.type == DATA_VOID ? "void" : brief(value)));
    }

    URBI_INLINE UDictionary& structure(UValue& value, const char* type)
    {
      if (value.type != DATA_DICTIONARY)
        bad_cast(type, value);
      return *value.dictionary;
    }

    URBI_INLINE UDictionary& make_structure(UValue& out, const char* type)
    {
      out = UValue(UDictionary());
      entry(*out.dictionary, "$sn") = UValue(type);
      return *out.dictionary;
    }

    URBI_INLINE UList& elements(UValue& value)
    {
      if (value.type != DATA_LIST)
        bad_cast("list", value);
      return *value.list;
    }
  }

  // ---------------------------------------------------------------- UList

  URBI_INLINE UList::UList()
    : offset(0)
  {}

  URBI_INLINE UList::UList(const UList& other)
    : offset(0)
  {
    *this = other;
  }

  URBI_INLINE UList::UList(UList&& other) noexcept
    : array(std::move(other.array))
    , offset(other.offset)
  {
    other.array.clear();
  }

  URBI_INLINE UList::~UList()
  {
    clear();
  }

  URBI_INLINE UList& UList::operator=(const UList& other)
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

  URBI_INLINE UList& UList::operator=(UList&& other) noexcept
  {
    if (this != &other)
    {
      array.swap(other.array);
      std::swap(offset, other.offset);
    }
    return *this;
  }

  URBI_INLINE void UList::pop_back()
  {
    delete array.back();
    array.pop_back();
  }

  URBI_INLINE UValue& UList::front()
  {
    return (*this)[0];
  }

  URBI_INLINE UValue& UList::operator[](size_t i)
  {
    return *array.at(i + offset);
  }

  URBI_INLINE const UValue& UList::operator[](size_t i) const
  {
    return *array.at(i + offset);
  }

  URBI_INLINE void UList::setOffset(size_t n)
  {
    offset = n < array.size() ? n : array.size();
  }

  URBI_INLINE std::ostream& UList::print(std::ostream& out) const
  {
    out << "[";
    for (size_t i = 0; i < size(); ++i)
      (*this)[i].print(out << (i ? ", " : ""));
    return out << "]";
  }

  URBI_INLINE void UList::clear()
  {
    for (UValue* element : array)
      delete element;
    array.clear();
    offset = 0;
  }

  URBI_INLINE std::ostream& operator<<(std::ostream& out, const UList& list)
  {
    return list.print(out);
  }

  // ---------------------------------------------------------------- UValue

  URBI_INLINE UValue::UValue(const UValue& other)
    : UValue()
  {
    set(other);
  }

  URBI_INLINE UValue::UValue(const char* text, bool)
    : UValue()
  {
    stringValue = new std::string(text ? text : "");
    type = DATA_STRING;
  }

  URBI_INLINE UValue::UValue(const std::string& text, bool)
    : UValue()
  {
    stringValue = new std::string(text);
    type = DATA_STRING;
  }

  URBI_INLINE UValue::UValue(const void* text, bool)
    : UValue(static_cast<const char*>(text))
  {}

  URBI_INLINE UValue::UValue(const UBinary& other, bool copy)
    : UValue()
  {
    binary = new UBinary(other, copy);
    type = DATA_BINARY;
  }

  URBI_INLINE UValue::UValue(const UImage& image, bool copy)
    : UValue()
  {
    binary = new UBinary(image, copy);
    type = DATA_BINARY;
  }

  URBI_INLINE UValue::UValue(const USound& sound, bool copy)
    : UValue()
  {
    binary = new UBinary(sound, copy);
    type = DATA_BINARY;
  }

  URBI_INLINE UValue::UValue(const UList& other, bool)
    : UValue()
  {
    list = new UList(other);
    type = DATA_LIST;
  }

  URBI_INLINE UValue::UValue(const UDictionary& other, bool)
    : UValue()
  {
    dictionary = new UDictionary(other);
    type = DATA_DICTIONARY;
  }

  URBI_INLINE UValue& UValue::operator=(const UValue& other)
  {
    return set(other);
  }

  URBI_INLINE UValue& UValue::set(const UValue& other, bool copied)
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

  URBI_INLINE void UValue::clear()
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

  URBI_INLINE const char* UValue::format_string() const
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

  URBI_INLINE ufloat UValue::number() const
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

  URBI_INLINE UValue::operator std::string() const
  {
    switch (type)
    {
    case DATA_STRING:
    case DATA_SLOTNAME: return *stringValue;
    case DATA_DOUBLE: return detail::number_text(val);
    default: detail::bad_cast("string", *this);
    }
  }

  URBI_INLINE UValue::operator const UBinary&() const
  {
    if (type != DATA_BINARY)
      detail::bad_cast("UBinary", *this);
    return *binary;
  }

  URBI_INLINE UValue& UValue::error()
  {
    static UValue none;
    none.clear();
    return none;
  }

  URBI_INLINE UNamedValue& UNamedValue::error()
  {
    static UNamedValue none;
    return none;
  }

  URBI_INLINE UValue::operator UList() const
  {
    if (type != DATA_LIST)
      detail::bad_cast("UList", *this);
    return *list;
  }

  URBI_INLINE UValue::operator UDictionary() const
  {
    if (type != DATA_DICTIONARY)
      detail::bad_cast("UDictionary", *this);
    return *dictionary;
  }

  URBI_INLINE UValue::operator UImage() const
  {
    if (type != DATA_BINARY)
      detail::bad_cast("UImage", *this);
    return binary->type == BINARY_IMAGE ? UImage(binary->image) : UImage();
  }

  URBI_INLINE UValue::operator USound() const
  {
    if (type != DATA_BINARY)
      detail::bad_cast("USound", *this);
    return binary->type == BINARY_SOUND ? USound(binary->sound) : USound();
  }

  URBI_INLINE int UValue::parse(const char* message, int pos, const binaries_type& bins,
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

  URBI_INLINE std::ostream& UValue::print(std::ostream& out) const
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

  URBI_INLINE std::ostream& operator<<(std::ostream& out, const UValue& value)
  {
    return value.print(out);
  }

  URBI_INLINE std::ostream& operator<<(std::ostream& out, const UDictionary& dictionary)
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

#endif
