/// Vectors and matrices of numbers.
#ifndef LIBPORT_UMATRIX_HH
#define LIBPORT_UMATRIX_HH

#include <cstddef>
#include <stdexcept>
#include <vector>

#include <libport/cmath>
#include <libport/ufloat.hh>

namespace libport
{
  /// A vector: in urbiscript a list of numbers.
  class vector_type : public std::vector<ufloat>
  {
  public:
    using std::vector<ufloat>::vector;

    ufloat& operator()(size_t i)
    {
      return at(i);
    }

    ufloat operator()(size_t i) const
    {
      return at(i);
    }
  };

  /// A matrix: in urbiscript a list of its rows.
  class matrix_type : public std::vector<vector_type>
  {
  public:
    matrix_type() = default;

    matrix_type(size_t rows, size_t columns)
      : std::vector<vector_type>(rows, vector_type(columns))
    {}

    size_t size1() const
    {
      return size();
    }

    size_t size2() const
    {
      return empty() ? 0 : front().size();
    }

    /// Makes it of that size.
    void resize(size_t rows, size_t columns)
    {
      std::vector<vector_type>::resize(rows);
      for (vector_type& row : *this)
        row.resize(columns);
    }

    ufloat& operator()(size_t row, size_t column)
    {
      return at(row).at(column);
    }

    ufloat operator()(size_t row, size_t column) const
    {
      return at(row).at(column);
    }
  };
}

#endif
