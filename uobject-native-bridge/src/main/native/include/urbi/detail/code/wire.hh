/// What urbi/detail/wire.hh declares: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/detail/wire.hh>

#ifndef URBI_DETAIL_CODE_WIRE_HH
#define URBI_DETAIL_CODE_WIRE_HH

namespace urbi
{
  namespace detail
  {
    URBI_INLINE void Writer::value(const UValue& v)
    {
      switch (v.type)
      {
      case DATA_VOID: nothing(); break;
      case DATA_DOUBLE: number(v.val); break;
      case DATA_STRING: string(*v.stringValue); break;
      case DATA_SLOTNAME:
        raw(static_cast<uint8_t>(MARK_SLOTNAME));
        text(*v.stringValue);
        break;
      case DATA_LIST:
        raw(static_cast<uint8_t>(MARK_LIST));
        raw(static_cast<uint32_t>(v.list->size()));
        for (size_t i = 0; i < v.list->size(); ++i)
          value((*v.list)[i]);
        break;
      case DATA_DICTIONARY:
        raw(static_cast<uint8_t>(MARK_DICTIONARY));
        raw(static_cast<uint32_t>(v.dictionary->size()));
        for (const auto& entry : *v.dictionary)
        {
          text(entry.first);
          value(entry.second);
        }
        break;
      case DATA_BINARY: binary(*v.binary); break;
      }
    }

    URBI_INLINE void Writer::binary(const UBinary& b)
    {
      raw(static_cast<uint8_t>(whole_ ? MARK_BINARY : MARK_POINTER));
      text(b.getMessage());
      raw(static_cast<int64_t>(b.common.size));
      if (!whole_)
        raw(static_cast<int64_t>(reinterpret_cast<intptr_t>(b.common.data)));
      else
        bytes(b.common.data, b.common.size);
    }

    URBI_INLINE void Writer::grow(int64_t wanted)
    {
      int64_t capacity = wanted > 2 * capacity_ ? wanted : 2 * capacity_;
      uint8_t* bigger = static_cast<uint8_t*>(
        std::realloc(begin_ == given_ ? nullptr : begin_, static_cast<size_t>(capacity)));
      if (!bigger)
        throw std::bad_alloc();
      if (begin_ == given_ && length_)
        std::memcpy(bigger, given_, static_cast<size_t>(length_));
      begin_ = bigger;
      capacity_ = capacity;
    }

    URBI_INLINE void Writer::text(const std::string& all)
    {
      raw(static_cast<uint32_t>(all.size()));
      bytes(all.data(), all.size());
    }

    URBI_INLINE std::string Reader::text()
    {
      uint32_t length = raw<uint32_t>();
      return std::string(reinterpret_cast<const char*>(take(length)), length);
    }

    URBI_INLINE void Reader::value(UValue& out)
    {
      switch (raw<uint8_t>())
      {
      case MARK_VOID: out.clear(); break;
      case MARK_NUMBER: out = UValue(raw<ufloat>()); break;
      case MARK_STRING: out = UValue(text()); break;
      case MARK_SLOTNAME:
        out = UValue(text());
        out.type = DATA_SLOTNAME;
        break;
      case MARK_LIST:
      {
        UValue made{UList()};
        uint32_t count = raw<uint32_t>();
        made.list->array.reserve(count);
        for (uint32_t i = 0; i < count; ++i)
        {
          made.list->array.push_back(new UValue());
          value(*made.list->array.back());
        }
        out = std::move(made);
        break;
      }
      case MARK_DICTIONARY:
      {
        UValue made{UDictionary()};
        uint32_t count = raw<uint32_t>();
        for (uint32_t i = 0; i < count; ++i)
        {
          std::string key = text();
          value(entry(*made.dictionary, key));
        }
        out = std::move(made);
        break;
      }
      case MARK_BINARY:
      {
        std::string header = text();
        size_t size = static_cast<size_t>(raw<int64_t>());
        out = UValue(UBinary());
        out.binary->set(header, const_cast<uint8_t*>(take(size)), size);
        break;
      }
      case MARK_POINTER:
      {
        std::string header = text();
        size_t size = static_cast<size_t>(raw<int64_t>());
        void* bytes = reinterpret_cast<void*>(static_cast<intptr_t>(raw<int64_t>()));
        if (out.type != DATA_BINARY)
          out = UValue(UBinary());
        out.binary->share(header, bytes, size);
        break;
      }
      default: throw std::runtime_error("malformed value");
      }
    }
  }
}

#endif
