/// Values one after the other.
#ifndef URBI_ULIST_HH
#define URBI_ULIST_HH

#include <ostream>
#include <vector>

#include <urbi/fwd.hh>

namespace urbi
{
  /// A list. It owns its elements.
  class UList
  {
  public:
    typedef std::vector<UValue*> list_type;
    typedef list_type::iterator iterator;
    typedef list_type::const_iterator const_iterator;

    UList();
    UList(const UList& other);
    UList(UList&& other) noexcept;
    ~UList();
    UList& operator=(const UList& other);
    UList& operator=(UList&& other) noexcept;

    /// Takes what is in a container.
    template <typename T>
    UList& operator=(const T& container);

    /// A container with these elements.
    template <typename T>
    T as() const;

    iterator begin();
    iterator end();
    const_iterator begin() const;
    const_iterator end() const;

    /// Appends an element of any type to which values can be converted.
    template <typename T>
    UList& push_back(const T& element);
    void pop_back();

    UValue& front();

    /// \throw std::out_of_range
    UValue& operator[](size_t i);
    const UValue& operator[](size_t i) const;

    size_t size() const;

    /// Has `begin`, `size` and indices leave out the first n elements.
    void setOffset(size_t n);

    std::ostream& print(std::ostream& out) const;

    /// The elements.
    list_type array;

  private:
    void clear();

    size_t offset;
  };

  std::ostream& operator<<(std::ostream& out, const UList& list);
}

#include <urbi/uvalue.hh>

#endif
