/// Values of any kind that urbiscript and C++ exchange.
#ifndef URBI_UVALUE_HH
#define URBI_UVALUE_HH

#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include <libport/containers.hh>
#include <libport/format.hh>
#include <libport/lexical-cast.hh>
#include <libport/preproc.hh>
#include <libport/traits.hh>
#include <libport/ufloat.h>

#include <urbi/detail/for-each.hh>
#include <urbi/export.hh>
#include <urbi/fwd.hh>
#include <urbi/ubinary.hh>
#include <urbi/ulist.hh>

namespace urbi
{
  enum UDataType
  {
    DATA_BINARY = 0,
    DATA_DICTIONARY = 1,
    DATA_DOUBLE = 2,
    DATA_LIST = 3,
    DATA_STRING = 5,
    DATA_SLOTNAME = 6,
    DATA_VOID = 7,
  };

  /// A value. Copies are deep.
  class UValue
  {
    template <typename T>
    using if_number = std::enable_if_t<std::is_arithmetic<T>::value, int>;

  public:
    UValue();
    UValue(const UValue& other);
    UValue(UValue&& other) noexcept;
    ~UValue();

    template <typename T, if_number<T> = 0>
    explicit UValue(T number, bool = true);
    explicit UValue(const char* text, bool = true);
    explicit UValue(const std::string& text, bool = true);

    /// Bytes without a header, up to the first 0, as a string.
    explicit UValue(const void* text, bool = true);

    /// \param copy  whether the data are copied, or shared with the binary
    explicit UValue(const UBinary& binary, bool copy = true);
    explicit UValue(const UImage& image, bool copy = true);
    explicit UValue(const USound& sound, bool copy = true);
    explicit UValue(const UList& list, bool = true);
    explicit UValue(const UDictionary& dictionary, bool = true);

    UValue& operator=(const UValue& other);
    UValue& operator=(UValue&& other) noexcept;

    /// Takes whatever can be converted, see uvalue_caster.
    template <typename T>
    UValue& operator=(const T& other);

    /// Becomes the same as another.
    ///
    /// \param copy  whether data of binaries are copied, or shared
    UValue& set(const UValue& other, bool copy = true);

    /// Becomes nothing.
    void clear();

    /// What stands for a value that is none.
    URBI_LOCAL static UValue& error();

    /// The kind of value in a word, for people.
    const char* format_string() const;

    /// The number, or the one that the string is; otherwise an exception.
    template <typename T, if_number<T> = 0>
    operator T() const;
    operator std::string() const;
    operator const UBinary&() const;
    operator UList() const;
    operator UDictionary() const;

    /// The image, which shares the data of this value; an empty one if it is another binary.
    operator UImage() const;

    /// The sound, which shares the data of this value; an empty one if it is another binary.
    operator USound() const;

    UValue& operator()()
    {
      return *this;
    }

    /// Reads an urbiscript literal.
    ///
    /// \param message  ends with 0
    /// \param pos      where the literal begins
    /// \param bins     data of the binaries in it
    /// \return where it ends; the negative position of the error if it is none
    int parse(const char* message, int pos, const binaries_type& bins,
              binaries_type::const_iterator& binpos);

    /// Writes it as an urbiscript literal.
    std::ostream& print(std::ostream& out) const;

    UDataType type;
    ufloat val; ///< DATA_DOUBLE
    union
    {
      std::string* stringValue; ///< DATA_STRING, DATA_SLOTNAME
      UBinary* binary;          ///< DATA_BINARY
      UList* list;              ///< DATA_LIST
      UDictionary* dictionary;  ///< DATA_DICTIONARY
      void* storage;
    };

    static const bool copy = true;

  private:
    void steal(UValue& other) noexcept;
    ufloat number() const;
  };

  std::ostream& operator<<(std::ostream& out, const UValue& value);
  std::ostream& operator<<(std::ostream& out, const UDictionary& dictionary);

  /// A value with a name.
  class UNamedValue
  {
  public:
    UNamedValue(const std::string& n = "", UValue* v = nullptr)
      : name(n)
      , val(v)
    {}

    /// What stands for one that is none.
    URBI_LOCAL static UNamedValue& error();

    std::string name;
    UValue* val;
  };

  /// Numbers that travel as one binary instead of a list.
  template <typename T>
  class UPackedData : public std::vector<T>
  {
    static_assert(std::is_trivially_copyable<T>::value, "UPackedData holds plain data");

  public:
    UPackedData()
    {}

    UPackedData(const std::vector<T>& other)
      : std::vector<T>(other)
    {}

    template <typename I>
    UPackedData(I begin, I end)
      : std::vector<T>(begin, end)
    {}
  };

  /// Says where the code that follows stands.
  inline std::string syncline_push(const std::string& folder, const std::string& file, unsigned line)
  {
    return "//#push " + std::to_string(line) + " \"" + folder + file + "\"\n";
  }

  /// Makes a C++ object of a value: specialize it for types of your own, and write
  /// `operator,(UValue&, const Type&)` for the way back (manual, "Extending the cast system").
  template <typename Type, typename = void>
  struct uvalue_caster;

  /// A value as an instance of a type.
  ///
  /// \throw std::runtime_error if it is not
  template <typename Type>
  std::remove_cv_t<std::remove_reference_t<Type>> uvalue_cast(UValue& value);
}

#include <urbi/uvalue.hxx>

/// Components of 2.7 name it without a namespace.
using urbi::UPackedData;

/// Urbiscript code with the place in C++ code where it stands: errors in it are told with that.
#define SYNCLINE_PUSH() "//#push " LIBPORT_STRINGIZE(__LINE__) " \"" __FILE__ "\"\n"
#define SYNCLINE_POP() "//#pop\n"
#define SYNCLINE_WRAP(...)                                                                        \
  (::urbi::syncline_push("", __FILE__, __LINE__) + ::libport::format(__VA_ARGS__) + "\n"          \
   + SYNCLINE_POP())

/// Casts a structure by value: \a Cname is its name in both languages, then its fields follow
/// (manual, "Casting simple structures").
#define URBI_REGISTER_STRUCT(Cname, ...)                                                          \
  namespace urbi                                                                                  \
  {                                                                                               \
    template <>                                                                                   \
    struct uvalue_caster<Cname>                                                                   \
    {                                                                                             \
      Cname operator()(UValue& v)                                                                 \
      {                                                                                           \
        Cname res;                                                                                \
        UDictionary& fields = ::urbi::detail::structure(v, #Cname);                               \
        URBI_FOR_EACH(URBI_STRUCT_READ_, Cname, __VA_ARGS__)                                      \
        return res;                                                                               \
      }                                                                                           \
    };                                                                                            \
                                                                                                  \
    inline UValue& operator,(UValue& v, const Cname& s)                                           \
    {                                                                                             \
      UDictionary& fields = ::urbi::detail::make_structure(v, #Cname);                            \
      URBI_FOR_EACH(URBI_STRUCT_WRITE_, Cname, __VA_ARGS__)                                       \
      return v;                                                                                   \
    }                                                                                             \
  }                                                                                               \
  static_assert(true, "")

#define URBI_STRUCT_READ_(Cname, Field)                                                           \
  ::urbi::detail::read_field(res.Field, fields, #Cname, #Field);
#define URBI_STRUCT_WRITE_(Cname, Field) ::urbi::detail::entry(fields, #Field) = s.Field;

#endif
