#ifndef rift_base_vector3_h
#define rift_base_vector3_h

#include <array>
#include <cmath>

namespace rift
{
  /**
   * A vector in space. `Number` is `double` or a SIMD vector of them. It is a
   * plain array, so that kernels and laws need no deal.II header.
   */
  template <typename Number>
  using Vector3 = std::array<Number, 3>;

  /** A matrix, row by row. */
  template <typename Number>
  using Matrix3 = std::array<Vector3<Number>, 3>;

  /** Sum of two vectors. */
  template <typename Number>
  inline Vector3<Number>
  operator+(const Vector3<Number> &a, const Vector3<Number> &b)
  {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
  }

  /** Difference of two vectors. */
  template <typename Number>
  inline Vector3<Number>
  operator-(const Vector3<Number> &a, const Vector3<Number> &b)
  {
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
  }

  /** A vector times a number. */
  template <typename Number>
  inline Vector3<Number>
  operator*(const Number &s, const Vector3<Number> &a)
  {
    return {{s * a[0], s * a[1], s * a[2]}};
  }

  /** Adds a vector to another. */
  template <typename Number>
  inline Vector3<Number> &
  operator+=(Vector3<Number> &a, const Vector3<Number> &b)
  {
    for (unsigned int d = 0; d < 3; ++d)
      a[d] = a[d] + b[d];
    return a;
  }

  /** Subtracts a vector from another. */
  template <typename Number>
  inline Vector3<Number> &
  operator-=(Vector3<Number> &a, const Vector3<Number> &b)
  {
    for (unsigned int d = 0; d < 3; ++d)
      a[d] = a[d] - b[d];
    return a;
  }

  /** Scalar product. */
  template <typename Number>
  inline Number
  dot(const Vector3<Number> &a, const Vector3<Number> &b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /** Vector product. */
  template <typename Number>
  inline Vector3<Number>
  cross(const Vector3<Number> &a, const Vector3<Number> &b)
  {
    return {{a[1] * b[2] - a[2] * b[1],
             a[2] * b[0] - a[0] * b[2],
             a[0] * b[1] - a[1] * b[0]}};
  }

  /** Euclidean norm. */
  inline double
  norm(const Vector3<double> &a)
  {
    return std::sqrt(dot(a, a));
  }

  /** Matrix times vector. */
  template <typename Number>
  inline Vector3<Number>
  operator*(const Matrix3<Number> &m, const Vector3<Number> &a)
  {
    return {{dot(m[0], a), dot(m[1], a), dot(m[2], a)}};
  }

  /** Determinant of a matrix. */
  template <typename Number>
  inline Number
  determinant(const Matrix3<Number> &m)
  {
    return dot(m[0], cross(m[1], m[2]));
  }

  /** Product of two matrices. */
  template <typename Number>
  inline Matrix3<Number>
  operator*(const Matrix3<Number> &a, const Matrix3<Number> &b)
  {
    Matrix3<Number> result{};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          result[i][j] += a[i][k] * b[k][j];
    return result;
  }

  /** By cofactors. */
  template <typename Number>
  inline Matrix3<Number>
  inverse(const Matrix3<Number> &m)
  {
    const Vector3<Number> columns[3] = {cross(m[1], m[2]),
                                        cross(m[2], m[0]),
                                        cross(m[0], m[1])};
    const Number          factor     = 1. / dot(m[0], columns[0]);
    Matrix3<Number>       result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        result[i][j] = factor * columns[j][i];
    return result;
  }
} // namespace rift

#endif
