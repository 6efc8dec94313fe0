#pragma once
/// The numbers of a matrix in a history, one after the other.

#include <sinew/core/plane_matrix.hpp>

namespace sinew {

template <class T>
void symmetric_numbers(PlaneMatrix<T>& m, auto&& use) {
  use(m.in_plane[0][0]);
  use(m.in_plane[1][1]);
  use(m.in_plane[0][1]);
  use(m.out_of_plane);
  m.in_plane[1][0] = m.in_plane[0][1];
}
template <class T>
void symmetric_numbers(Mat3<T>& m, auto&& use) {
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      use(m[i][j]);
      m[j][i] = m[i][j];
    }
}

template <class T>
void all_numbers(Mat3<T>& m, auto&& use) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) use(m[i][j]);
}
template <class T>
void all_numbers(PlaneMatrix<T>& m, auto&& use) {
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) use(m.in_plane[i][j]);
  use(m.out_of_plane);
}

}  // namespace sinew
