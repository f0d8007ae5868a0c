// Fields of a contact that rolls and spins, by itself.
#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"
#include "bearing/film/film_choice.hpp"

namespace orbearing::app::table {

void add_film_fields(std::vector<Field>& fields) {
  add_described(fields, bearing::film::EllipticalContact{});
  add_described(fields, bearing::film::LineContact{});
  Field& ellipse = row_of(fields, "contact.ellipticity");
  ellipse.required_by = no_model;  // consistency.cpp asks for one of the two
  ellipse.under(where_absent("contact.length"));
  add_described(fields, bearing::film::FilmChoice{});
  Rows(fields, spin_film)
      .list_of_rows("points", "loads and motions for which the film is computed", Use(use::spin_film, 0),
                    {{"load", dimension::force, positive(1e9)},
                     {"rolling speed", dimension::speed, positive(1e4)},
                     {"spin", dimension::spin, {-1e6, 1e6}}})
      .required();
}

}  // namespace orbearing::app::table
