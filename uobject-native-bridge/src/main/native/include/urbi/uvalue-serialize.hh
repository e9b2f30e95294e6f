/// Values in binary streams.
#ifndef URBI_UVALUE_SERIALIZE_HH
#define URBI_UVALUE_SERIALIZE_HH

#include <istream>
#include <ostream>
#include <string>

#include <serialize/serialize.hh>

#include <libport/lexical-cast.hh>

#include <urbi/uvalue.hh>

namespace urbi
{
  /// Writes a value: its kind, then what is in it. Data of binaries go to \a out as they are.
  template <class Archive>
  void saveUValue(Archive& archive, const UValue& value, std::ostream& out)
  {
    archive << static_cast<unsigned char>(value.type);
    switch (value.type)
    {
    case DATA_BINARY:
      archive << value.binary->getMessage() << static_cast<unsigned int>(value.binary->common.size);
      out.write(static_cast<const char*>(value.binary->common.data),
                static_cast<std::streamsize>(value.binary->common.size));
      break;
    case DATA_DICTIONARY:
      archive << static_cast<unsigned int>(value.dictionary->size());
      for (const auto& each : *value.dictionary)
      {
        archive << each.first;
        saveUValue(archive, each.second, out);
      }
      break;
    case DATA_LIST:
      archive << static_cast<unsigned int>(value.list->size());
      for (const UValue* each : *value.list)
        saveUValue(archive, *each, out);
      break;
    case DATA_DOUBLE: archive << value.val; break;
    case DATA_STRING:
    case DATA_SLOTNAME: archive << *value.stringValue; break;
    case DATA_VOID: break;
    }
  }

  /// Reads a value. \throw std::runtime_error if there is none
  template <class Archive>
  void loadUValue(Archive& archive, UValue& value, std::istream& in)
  {
    unsigned char kind = DATA_VOID;
    unsigned int size = 0;
    std::string text;
    archive >> kind;
    value.clear();
    switch (kind)
    {
    case DATA_BINARY:
    {
      archive >> text >> size;
      std::string data;
      for (char byte; data.size() < size && in.get(byte);)
        data += byte;
      if (data.size() < size)
        throw std::runtime_error("truncated binary");
      value = UValue(UBinary());
      value.binary->set(text, &data[0], data.size());
      break;
    }
    case DATA_DICTIONARY:
      value = UValue(UDictionary());
      for (archive >> size; size; --size)
      {
        archive >> text;
        loadUValue(archive, (*value.dictionary)[text], in);
      }
      break;
    case DATA_LIST:
      value = UValue(UList());
      for (archive >> size; size; --size)
      {
        UValue element;
        loadUValue(archive, element, in);
        value.list->push_back(element);
      }
      break;
    case DATA_DOUBLE:
    {
      ufloat number = 0;
      archive >> number;
      value = UValue(number);
      break;
    }
    case DATA_STRING:
    case DATA_SLOTNAME:
      archive >> text;
      value = UValue(text);
      value.type = static_cast<UDataType>(kind);
      break;
    case DATA_VOID: break;
    default: throw std::runtime_error("unknown kind of value in a stream");
    }
  }
}

namespace libport
{
  namespace serialize
  {
    inline BinaryOSerializer& operator<<(BinaryOSerializer& out, const urbi::UValue& value)
    {
      urbi::saveUValue(out, value, out.stream());
      return out;
    }

    inline BinaryISerializer& operator>>(BinaryISerializer& in, urbi::UValue& value)
    {
      urbi::loadUValue(in, value, in.stream());
      return in;
    }
  }
}

#endif
