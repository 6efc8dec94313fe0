#pragma once
/// A registry is a list of types, each with a `static constexpr std::string_view name`. No static-initializer magic.

#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace sinew {

template <class... Ts>
struct TypeList {
  using Variant = std::variant<Ts...>;
  static constexpr std::size_t size = sizeof...(Ts);

  /// Calls `f.template operator()<T>()` for every type of the list, in order.
  template <class F>
  static void for_each(F&& f) {
    (f.template operator()<Ts>(), ...);
  }
  /// Calls `f.template operator()<T>()` for the type of that name; false if there is none.
  template <class F>
  static bool with_name(std::string_view name, F&& f) {
    return ((name == Ts::name ? (f.template operator()<Ts>(), true) : false) || ...);
  }
  static std::vector<std::string> names() { return {std::string(Ts::name)...}; }
};

namespace detail {
template <class A, class B>
struct Join;
template <class... As, class... Bs>
struct Join<TypeList<As...>, TypeList<Bs...>> {
  using Type = TypeList<As..., Bs...>;
};
}  // namespace detail

/// The types of one list and of another.
template <class A, class B>
using Joined = typename detail::Join<A, B>::Type;

}  // namespace sinew
