/// How C++ types become values and values become C++ types.
#ifndef URBI_DETAIL_CASTERS_HH
#define URBI_DETAIL_CASTERS_HH

#include <array>
#include <iterator>
#include <list>
#include <map>
#if __cplusplus >= 201703L
#include <optional>
#endif
#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include <urbi/uvalue.hh>

namespace urbi
{
  namespace detail
  {
    template <typename T>
    using plain = std::remove_cv_t<std::remove_reference_t<T>>;

    template <typename...>
    using exists = void;

    /// Whether something can be iterated over.
    template <typename T, typename = void>
    struct is_range : std::false_type
    {};
    template <typename T>
    struct is_range<T,
                    exists<decltype(std::begin(std::declval<const T&>())),
                           decltype(std::end(std::declval<const T&>())), typename T::value_type>>
      : std::true_type
    {};

    /// Whether it is a container of pairs whose keys are strings.
    template <typename T, typename = void>
    struct is_dictionary : std::false_type
    {};
    template <typename T>
    struct is_dictionary<T, exists<typename T::key_type, typename T::mapped_type>>
      : std::is_convertible<typename T::key_type, std::string>
    {};

    /// Whether elements can be appended to it.
    template <typename T, typename = void>
    struct can_grow : std::false_type
    {};
    template <typename T>
    struct can_grow<T,
                    exists<decltype(std::declval<T&>().insert(
                      std::declval<T&>().end(), std::declval<typename T::value_type>()))>>
      : is_range<T>
    {};

    /// What can be a T, and nothing that would have to be made of one.
    template <typename T>
    struct Exactly
    {
      operator const T&() const;
    };

    /// What is asked whether there is an `operator,` for it. Numbers, enumerations and pointers are
    /// asked for exactly: a structure with a constructor that takes one of them stands for none.
    template <typename T>
    using asked = std::conditional_t<std::is_class<T>::value, T, Exactly<T>>;

    /// Whether somebody has written `operator,(UValue&, const T&)`: the one of the language has the
    /// type of its right side.
    template <typename T>
    struct has_comma
      : std::bool_constant<!std::is_same<
          decltype((std::declval<UValue&>(), std::declval<const asked<T>&>())), const asked<T>&>::value>
    {};

    /// Types that are values by themselves.
    template <typename T>
    struct is_plain
      : std::bool_constant<
          std::is_arithmetic<T>::value || std::is_same<T, std::string>::value
          || std::is_same<T, UValue>::value || std::is_same<T, UBinary>::value
          || std::is_same<T, UImage>::value || std::is_same<T, USound>::value
          || std::is_same<T, UList>::value || std::is_same<T, UDictionary>::value>
    {};

    template <typename T>
    struct is_packed : std::false_type
    {};
    template <typename T>
    struct is_packed<UPackedData<T>> : std::true_type
    {};

    template <typename T>
    struct is_optional : std::false_type
    {};
#if __cplusplus >= 201703L
    template <typename T>
    struct is_optional<std::optional<T>> : std::true_type
    {};
#endif

    // Defined with UObject.
    UObject* object_of(const UValue& value);
    UValue name_of(const UObject* object);
    UValue name_of(const UVar& variable);

    template <typename T>
    void to_uvalue(UValue& out, const T& object);

    template <typename T>
    void dictionary_to_uvalue(UValue& out, const T& all)
    {
      UDictionary made;
      for (const auto& each : all)
        to_uvalue(entry(made, each.first), each.second);
      out = UValue(made);
    }

    template <typename T>
    void range_to_uvalue(UValue& out, const T& all)
    {
      out = UValue(UList());
      for (const auto& element : all)
        out.list->push_back(static_cast<const typename T::value_type&>(element));
    }

    /// Makes `out` the value that stands for an object.
    template <typename T>
    void to_uvalue(UValue& out, const T& object)
    {
      if constexpr (is_plain<T>::value)
        out = UValue(object);
      else if constexpr (is_packed<T>::value)
      {
        UBinary bytes;
        bytes.set("packed", const_cast<void*>(static_cast<const void*>(object.data())),
                  object.size() * sizeof(typename T::value_type), false);
        out = UValue(bytes);
      }
      else if constexpr (has_comma<T>::value)
        out, object;
      else if constexpr (std::is_same<T, UImageImpl>::value)
        out = UValue(static_cast<const UImage&>(object));
      else if constexpr (std::is_same<T, USoundImpl>::value)
        out = UValue(static_cast<const USound&>(object));
      else if constexpr (std::is_base_of<UVar, T>::value)
        out = name_of(static_cast<const UVar&>(object));
      else if constexpr (std::is_convertible<T, const UObject*>::value
                         && !std::is_same<T, std::nullptr_t>::value)
        out = name_of(object);
      else if constexpr (std::is_enum<T>::value)
        out = UValue(static_cast<ufloat>(object));
      else if constexpr (std::is_convertible<const T&, const char*>::value)
        out = UValue(static_cast<const char*>(object));
      else if constexpr (is_optional<T>::value)
      {
        out.clear();
        if (object)
          to_uvalue(out, *object);
      }
      else if constexpr (is_dictionary<T>::value)
        dictionary_to_uvalue(out, object);
      else if constexpr (is_range<T>::value)
        range_to_uvalue(out, object);
      else if constexpr (std::is_convertible<const T&, std::string>::value)
        out = UValue(static_cast<std::string>(object));
      else
        static_assert(has_comma<T>::value,
                      "no value stands for this type: write operator,(UValue&, const Type&)");
    }

    /// The fields of a structure.
    UDictionary& structure(UValue& value, const char* type);

    /// Makes a value a structure.
    UDictionary& make_structure(UValue& out, const char* type);

    template <typename T>
    void read_field(T& field, UDictionary& fields, const char* type, const char* name)
    {
      UDictionary::iterator found = fields.find(name);
      if (found == fields.end())
        throw std::runtime_error(std::string("a ") + type + " is missing field " + name);
      field = uvalue_cast<T>(found->second);
    }

    UList& elements(UValue& value);
  }

  template <typename T>
  UValue& UValue::operator=(const T& other)
  {
    if constexpr (std::is_array<T>::value)
      detail::to_uvalue(*this, static_cast<const std::remove_extent_t<T>*>(other));
    else
    {
      // The old value lives on until the new one is whole: that may be a part of it.
      UValue made;
      detail::to_uvalue(made, other);
      *this = std::move(made);
    }
    return *this;
  }

  // ---------------------------------------------------------------- commas

  // Components write `value, object;` in casters of their own. Those that are exact come first: a
  // structure that can be made of a list is none.

  template <typename T, std::enable_if_t<detail::is_plain<T>::value, int> = 0>
  inline UValue& operator,(UValue& v, const T& object)
  {
    return v = UValue(object);
  }

  inline UValue& operator,(UValue& v, const char* text)
  {
    return v = UValue(text);
  }

  template <typename... P>
  inline UValue& operator,(UValue& v, const std::vector<P...>& all)
  {
    detail::range_to_uvalue(v, all);
    return v;
  }

  template <typename... P>
  inline UValue& operator,(UValue& v, const std::list<P...>& all)
  {
    detail::range_to_uvalue(v, all);
    return v;
  }

  template <typename... P>
  inline UValue& operator,(UValue& v, const std::set<P...>& all)
  {
    detail::range_to_uvalue(v, all);
    return v;
  }

  template <typename... P>
  inline UValue& operator,(UValue& v, const std::map<std::string, P...>& all)
  {
    detail::dictionary_to_uvalue(v, all);
    return v;
  }

  template <typename... P>
  inline UValue& operator,(UValue& v, const std::unordered_map<std::string, P...>& all)
  {
    detail::dictionary_to_uvalue(v, all);
    return v;
  }

  // ---------------------------------------------------------------- casters

  template <typename T>
  struct uvalue_caster<T, std::enable_if_t<std::is_arithmetic<T>::value>>
  {
    T operator()(UValue& v)
    {
      return static_cast<T>(v);
    }
  };

  template <typename T>
  struct uvalue_caster<T, std::enable_if_t<std::is_enum<T>::value>>
  {
    T operator()(UValue& v)
    {
      return static_cast<T>(static_cast<long long>(v));
    }
  };

  template <>
  struct uvalue_caster<std::string>
  {
    std::string operator()(UValue& v)
    {
      return static_cast<std::string>(v);
    }
  };

  /// The text lives as long as the value.
  template <>
  struct uvalue_caster<const char*>
  {
    const char* operator()(UValue& v)
    {
      if (v.type == DATA_DOUBLE)
        v = static_cast<std::string>(v);
      if (v.type != DATA_STRING && v.type != DATA_SLOTNAME)
        detail::bad_cast("string", v);
      return v.stringValue->c_str();
    }
  };

  template <>
  struct uvalue_caster<UValue>
  {
    UValue operator()(UValue& v)
    {
      return v;
    }
  };

  template <>
  struct uvalue_caster<UBinary>
  {
    UBinary operator()(UValue& v)
    {
      return static_cast<const UBinary&>(v);
    }
  };

  /// The image shares the data of the value.
  template <>
  struct uvalue_caster<UImage>
  {
    UImage operator()(UValue& v)
    {
      return static_cast<UImage>(v);
    }
  };

  /// The sound shares the data of the value.
  template <>
  struct uvalue_caster<USound>
  {
    USound operator()(UValue& v)
    {
      return static_cast<USound>(v);
    }
  };

  template <>
  struct uvalue_caster<UList>
  {
    UList operator()(UValue& v)
    {
      return static_cast<UList>(v);
    }
  };

  template <>
  struct uvalue_caster<UDictionary>
  {
    UDictionary operator()(UValue& v)
    {
      return static_cast<UDictionary>(v);
    }
  };

  /// The C++ object behind an object; null for nothing, and for an object that is in another process or
  /// of urbiscript alone.
  template <typename T>
  struct uvalue_caster<T*, std::enable_if_t<std::is_base_of<UObject, T>::value>>
  {
    T* operator()(UValue& v)
    {
      if (v.type == DATA_VOID)
        return nullptr;
      UObject* found = detail::object_of(v);
      if (found && !dynamic_cast<T*>(found))
        detail::bad_cast("UObject", v);
      return dynamic_cast<T*>(found);
    }
  };

  template <typename T>
  struct uvalue_caster<UPackedData<T>>
  {
    UPackedData<T> operator()(UValue& v)
    {
      if (v.type == DATA_LIST)
        return UPackedData<T>(uvalue_cast<std::vector<T>>(v));
      const UBinary& binary = v;
      UPackedData<T> made;
      made.resize(binary.common.size / sizeof(T));
      if (!made.empty())
        std::memcpy(made.data(), binary.common.data, made.size() * sizeof(T));
      return made;
    }
  };

#if __cplusplus >= 201703L
  template <typename T>
  struct uvalue_caster<std::optional<T>>
  {
    std::optional<T> operator()(UValue& v)
    {
      if (v.type == DATA_VOID)
        return std::nullopt;
      return uvalue_cast<T>(v);
    }
  };
#endif

  template <typename T, size_t Size>
  struct uvalue_caster<std::array<T, Size>>
  {
    std::array<T, Size> operator()(UValue& v)
    {
      UList& list = detail::elements(v);
      if (list.size() != Size)
        throw std::runtime_error("a list of " + detail::number_text(static_cast<ufloat>(Size)) + " elements is wanted, not of "
                                 + detail::number_text(static_cast<ufloat>(list.size())));
      std::array<T, Size> made;
      for (size_t i = 0; i < Size; ++i)
        made[i] = uvalue_cast<T>(list[i]);
      return made;
    }
  };

  template <typename T, typename U>
  struct uvalue_caster<std::pair<T, U>>
  {
    std::pair<T, U> operator()(UValue& v)
    {
      UList& list = detail::elements(v);
      if (list.size() != 2)
        detail::bad_cast("pair", v);
      return std::pair<T, U>(uvalue_cast<T>(list[0]), uvalue_cast<U>(list[1]));
    }
  };

  template <typename T, typename U>
  inline UValue& operator,(UValue& v, const std::pair<T, U>& pair)
  {
    v = UValue(UList());
    v.list->push_back(pair.first);
    v.list->push_back(pair.second);
    return v;
  }

  /// Dictionaries of any kind.
  template <typename T>
  struct uvalue_caster<T, std::enable_if_t<detail::is_dictionary<T>::value>>
  {
    T operator()(UValue& v)
    {
      if (v.type != DATA_DICTIONARY)
        detail::bad_cast("dictionary", v);
      T made;
      for (auto& entry : *v.dictionary)
        made.insert(typename T::value_type(entry.first,
                                           uvalue_cast<typename T::mapped_type>(entry.second)));
      return made;
    }
  };

  /// Sequences and sets of any kind; what is no list is the only element.
  template <typename T>
  struct uvalue_caster<
    T, std::enable_if_t<detail::can_grow<T>::value && !detail::is_dictionary<T>::value
                         && !detail::is_packed<T>::value && !std::is_same<T, std::string>::value>>
  {
    T operator()(UValue& v)
    {
      T made;
      if (v.type == DATA_LIST)
        for (UValue* element : *v.list)
          made.insert(made.end(), uvalue_cast<typename T::value_type>(*element));
      else if (v.type != DATA_VOID)
        made.insert(made.end(), uvalue_cast<typename T::value_type>(v));
      return made;
    }
  };

  template <typename Type>
  std::remove_cv_t<std::remove_reference_t<Type>> uvalue_cast(UValue& value)
  {
    return uvalue_caster<detail::plain<Type>>()(value);
  }
}

#endif
