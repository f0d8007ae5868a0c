/* The program for languages that call C functions. Requests and results are JSON, tables of numbers are
 * pointers.
 *
 * A function returns NULL if it succeeds, else its failure {"kind": K, "messages": [...]}. K is "input" (a
 * mistake that the user can correct), "computation" (sound input whose computation failed), "interrupted"
 * (stopped by the progress function or by a signal) or "other" (an error of the program).
 *
 * Texts are UTF-8. What a function returns, failures included, belongs to the caller: orbearing_free().
 * Threads may share a case or a table, but not a machine. These functions stay within a major version. */
#ifndef ORBEARING_C_INTERFACE_H
#define ORBEARING_C_INTERFACE_H

#include <stddef.h> /* NOLINT: C */

#ifdef __cplusplus
extern "C" {
#endif

typedef struct orbearing_case orbearing_case;       /* NOLINT: C */
typedef struct orbearing_machine orbearing_machine; /* NOLINT: C */
typedef struct orbearing_table orbearing_table;     /* NOLINT: C */

/* Called from any thread, one call at a time. A result other than 0 stops the computation. */
typedef int (*orbearing_progress)(size_t done, size_t all, const char* doing, void* caller); /* NOLINT: C */

const char* orbearing_version(void);         /* of the library: not to be freed */
const char* orbearing_instruction_set(void); /* likewise */
void orbearing_free(void* memory);

/* The interpreter that draws reports, and the folder with the Python package "orbearing". To be called first.
 */
char* orbearing_use_python(const char* interpreter, const char* package);

/* The command line in this process; returns its exit code. */
int orbearing_command_line(int count, char** words);

/* A case from {"file": F} or {"text": T, "name": N}; "settings": [["path", "text"], ...] replaces values. */
char* orbearing_case_read(const char* stated, orbearing_case** found);
/* A copy with values replaced: [["path", "text of a case file"], ["path", number in SI], ...]. */
char* orbearing_case_with(const orbearing_case* from, const char* settings, orbearing_case** found);
/* The single operating point of its values. */
char* orbearing_case_without_sweep(const orbearing_case* from, orbearing_case** found);
void orbearing_case_delete(orbearing_case* stated);

/* What a case states, as JSON. {"of": O} with O: name, model, file, hash, resolved, inputs, axes.
 * {"of": O, "path": P} with O: value (in SI), given (as written), si ("text" in SI; a text or a list of
 * texts).
 * {"of": "si_units", "path": P} takes no case: [unit, [[column, unit], ...]], or null. */
char* orbearing_case_query(const orbearing_case* stated, const char* query, char** result);

/* A command of the command line: {"command": C, "options": {...}} with the names of its options, _ for -.
 * `stated` may be NULL. The result is what --json prints, `failures` a list of lines about points that
 * failed. */
char* orbearing_request(const orbearing_case* stated, const char* request, orbearing_progress progress,
                        void* caller, char** result, char** failures);

/* Operating points: {"paths": [...], "fidelity": F, "jobs": N}; `values` [SI] has a row for each of `count`
 * points. The result is {"columns": [...], "status": [...]}; `table` has a row of all columns for each point.
 */
char* orbearing_evaluate(const orbearing_case* stated, const char* request, const double* values,
                         size_t count, orbearing_progress progress, void* caller, char** result,
                         double** table);

/* Results that `orbearing table` tabulated (table.hpp): a file table.json or the folder that holds it. */
char* orbearing_table_read(const char* file, orbearing_table** found);
void orbearing_table_delete(orbearing_table* table);
char* orbearing_table_case(const orbearing_table* table, orbearing_case** found);
/* {"results": [...], "inputs": [[path, from, to], ...], "bound": B} */
char* orbearing_table_content(const orbearing_table* table, char** result);
/* {"result": R, "bound": B or null, "compute": true or false, "jobs": N}; `values` [SI] has a row of all
 * inputs for each of `count` queries. `answers` has a row of value, error and 1 or 0 (computed by the program
 * or not) for each; `failures` is a list of [query, reason]. */
char* orbearing_table_answers(const orbearing_table* table, const char* request, const double* values,
                              size_t count, double** answers, char** failures);

/* A bearing of a planet ("bearing") or the gear set ("gearset") that the caller moves (participant.hpp). */
char* orbearing_machine_make(const orbearing_case* stated, const char* model, orbearing_machine** made);
void orbearing_machine_delete(orbearing_machine* machine);
/* {"inputs": [[name, unit, meaning], ...], "outputs": [...]} */
char* orbearing_machine_ports(const orbearing_machine* machine, char** result);
/* `slope` [unit/s] may be NULL. */
char* orbearing_machine_set_input(orbearing_machine* machine, const char* name, double value,
                                  const double* slope);
char* orbearing_machine_input(const orbearing_machine* machine, const char* name, double* value);
char* orbearing_machine_initialize(orbearing_machine* machine, double time);
char* orbearing_machine_advance(orbearing_machine* machine, double length);
char* orbearing_machine_output(orbearing_machine* machine, const char* name, double* value);
char* orbearing_machine_outputs(orbearing_machine* machine, double** values, size_t* count);
char* orbearing_machine_slope(orbearing_machine* machine, const char* output, const char* input,
                              double* value);
double orbearing_machine_time(const orbearing_machine* machine); /* [s] */
char* orbearing_machine_save(orbearing_machine* machine, double** state, size_t* count);
char* orbearing_machine_restore(orbearing_machine* machine, const double* state, size_t count);

#ifdef __cplusplus
}
#endif

#endif
