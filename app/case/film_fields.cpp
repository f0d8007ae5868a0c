// Fields of a contact that rolls and spins, by itself.
#include "app/case/described_fields.hpp"
#include "app/case/field_table.hpp"
#include "bearing/film/film_choice.hpp"

namespace orbearing::app::table {

void add_film_fields(std::vector<Field>& fields) {
  add_described(fields, bearing::film::EllipticalContact{});
  add_described(fields, bearing::film::LineContact{});
  for (Field& field : fields) {
    if (field.path != "contact.ellipticity") continue;
    field.required_by = no_model;  // consistency.cpp asks for one of the two
    field.use = field.use.when(where_absent("contact.length"));
  }
  add_described(fields, bearing::film::FilmChoice{});
  fields.push_back({.path = "points",
                    .kind = Kind::list,
                    .meaning = "loads and motions for which the film is computed",
                    .use = Use(use::spin_film, 0),
                    .models = spin_film,
                    .required_by = spin_film,
                    .element = Kind::list,
                    .columns = {{"load", dimension::force, positive(1e9)},
                                {"rolling speed", dimension::speed, positive(1e4)},
                                {"spin", dimension::spin, {-1e6, 1e6}}}});
}

}  // namespace orbearing::app::table
