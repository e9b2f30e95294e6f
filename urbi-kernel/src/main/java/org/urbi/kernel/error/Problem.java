package org.urbi.kernel.error;

import static org.urbi.kernel.error.ProblemKind.ARGUMENT;
import static org.urbi.kernel.error.ProblemKind.ARGUMENT_TYPE;
import static org.urbi.kernel.error.ProblemKind.ARITY;
import static org.urbi.kernel.error.ProblemKind.ASSERTION;
import static org.urbi.kernel.error.ProblemKind.BAD_INTEGER;
import static org.urbi.kernel.error.ProblemKind.BAD_NUMBER;
import static org.urbi.kernel.error.ProblemKind.CONSTNESS;
import static org.urbi.kernel.error.ProblemKind.FILE_NOT_FOUND;
import static org.urbi.kernel.error.ProblemKind.IMPLICIT_TAG;
import static org.urbi.kernel.error.ProblemKind.KEY_ERROR;
import static org.urbi.kernel.error.ProblemKind.LINE;
import static org.urbi.kernel.error.ProblemKind.LOOKUP;
import static org.urbi.kernel.error.ProblemKind.MATCH_FAILURE;
import static org.urbi.kernel.error.ProblemKind.NEGATIVE_NUMBER;
import static org.urbi.kernel.error.ProblemKind.NON_POSITIVE_NUMBER;
import static org.urbi.kernel.error.ProblemKind.PART;
import static org.urbi.kernel.error.ProblemKind.PRIMITIVE;
import static org.urbi.kernel.error.ProblemKind.PROPERTY_LOOKUP;
import static org.urbi.kernel.error.ProblemKind.REDEFINITION;
import static org.urbi.kernel.error.ProblemKind.SCHEDULING;
import static org.urbi.kernel.error.ProblemKind.SYNTAX;
import static org.urbi.kernel.error.ProblemKind.TIME_OUT;
import static org.urbi.kernel.error.ProblemKind.TYPE;
import static org.urbi.kernel.error.ProblemKind.UNEXPECTED_VOID;
import static org.urbi.kernel.error.ProblemKind.WARNING;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.problem.Template;

/**
 * The catalogue of the messages of the language, in the words of the manual; those of the parser
 * are {@link org.urbi.lang.problem.SyntaxProblem}. To find where a message comes from, search here
 * for its text, and in the code for its name. {@code docs/messages.md} is generated from this
 * class.
 */
public enum Problem {
  // ------------------------------------------------------------------ names and slots

  NOT_FOUND(LOOKUP, "lookup failed: {name}"),
  MISSPELLED(LOOKUP, "lookup failed: {name} (possible misspelling of {other})"),
  PROPERTY_NOT_FOUND(
      PROPERTY_LOOKUP, "property lookup failed: {name}", "x->name = value gives a slot a property"),
  REDEFINED(REDEFINITION, "slot redefinition: {name}", "without var, the slot gets another value"),
  CONSTANT(CONSTNESS, "cannot modify const slot", "what is declared const keeps its value"),
  NO_LOCAL_SLOT(WARNING, "no such local slot: {name}"),
  NO_PROPERTY(WARNING, "no such property: {slot}->{property}"),
  NOT_INHERITABLE_FINALIZABLE(
      PRIMITIVE, "cannot inherit from a Finalizable without being one", "clone a Finalizable"),
  NOT_INHERITABLE_FLOAT(
      PRIMITIVE, "cannot inherit from a Float without being one", "clone a Float"),
  BLEND_MODE(PRIMITIVE, "invalid blend mode: {value}"),
  BAD_IMPLICIT_TAG(IMPLICIT_TAG, "invalid component in implicit tag"),

  // ------------------------------------------------------------------ calls and values

  VOID(
      UNEXPECTED_VOID,
      "unexpected void",
      "a function without a value was called where one is needed"),
  UNMATCHED(
      MATCH_FAILURE,
      "pattern did not match",
      "= gives a value to a name or a slot; a pattern before it has the form of the value"),
  IN_ROUTINE(PART, "{routine}: {message}"),
  ARGUMENTS_EXACTLY(ARITY, "{routine}: expected {minimum} argument{s}, given {given}"),
  ARGUMENTS_AT_LEAST(ARITY, "{routine}: expected at least {minimum} argument{s}, given {given}"),
  ARGUMENTS_BETWEEN(
      ARITY, "{routine}: expected between {minimum} and {maximum} argument{s}, given {given}"),
  WRONG_ARGUMENT(ARGUMENT, "{routine}: argument {index}: {reason}"),
  WRONG_TARGET(ARGUMENT, "{routine}: this: {reason}"),
  WRONG_TYPE(TYPE, "unexpected {value}, expected {a} {type}"),
  WRONG_ARGUMENT_TYPE(ARGUMENT_TYPE, "{routine}: argument {index}: {reason}"),
  NOT_INTEGER(BAD_INTEGER, "expected integer, got {value}"),
  NOT_NON_NEGATIVE_INTEGER(BAD_INTEGER, "expected non-negative integer, got {value}"),
  NEGATIVE(NEGATIVE_NUMBER, "unexpected {effective}, expected non-negative number"),
  NOT_POSITIVE(NON_POSITIVE_NUMBER, "unexpected {effective}, expected positive number"),
  NOT_BYTE_NEGATIVE(BAD_NUMBER, "bad numeric conversion: negative overflow: {value}"),
  NOT_BYTE_TOO_LARGE(BAD_NUMBER, "bad numeric conversion: positive overflow: {value}"),
  NOT_BYTE_FRACTION(
      BAD_NUMBER, "bad numeric conversion: overflow or non empty fractional part: {value}"),
  VOID_ARGUMENT(PRIMITIVE, "unexpected void"),
  WITHOUT_THIS(PRIMITIVE, "argument list must begin with `this'"),
  INDEX(
      PRIMITIVE,
      "invalid index: {index}",
      "the first has the index 0, the last of a list -1; list << value makes it longer"),
  ASSERTION_FAILED(ASSERTION, "failed assertion: {claim}"),
  ASSERTION_FAILED_WITH(
      ASSERTION, "failed assertion: {claim} ({values})", "the values are in parentheses"),

  // ------------------------------------------------------------------ numbers, texts, collections

  DIVISION_BY_ZERO(PRIMITIVE, "division by 0", "check the divisor first: if (x != 0) …"),
  MODULO_BY_ZERO(PRIMITIVE, "modulo by 0", "check the divisor first: if (x != 0) …"),
  RANGE(PRIMITIVE, "invalid range", "sines and cosines are from -1 to 1"),
  HAS_TO_BE_POSITIVE(PRIMITIVE, "argument has to be positive"),
  MATRIX_TOO_LARGE(PRIMITIVE, "matrix too large"),
  INCOMPATIBLE_SIZES(PRIMITIVE, "incompatible sizes"),
  NOT_A_NUMBER(
      PRIMITIVE, "cannot convert to float: {text}", "numbers are written as 12, -1.5, 1e3, 0xFF"),
  CHARACTER_CODE(PRIMITIVE, "invalid character code: {code}"),
  EMPTY_STRING(
      PRIMITIVE,
      "cannot be applied onto empty string",
      "if (!text.empty) … looks first whether there is any"),
  REPLACES_EMPTY_STRING(PRIMITIVE, "cannot replace the empty string"),
  STRING_TOO_LONG(PRIMITIVE, "string too long"),
  LIST_TOO_LONG(PRIMITIVE, "list too long"),
  EMPTY_LIST(
      PRIMITIVE,
      "cannot be applied onto empty list",
      "if (!list.empty) … looks first whether there is any"),
  NOTHING_TO_COMPARE(PRIMITIVE, "list cannot be empty"),
  LISTS_OF_SIZES(PRIMITIVE, "lists must have the same size"),
  TUPLES_OF_SIZES(PRIMITIVE, "tuples must have the same size"),
  ODD_ARGUMENTS(
      PRIMITIVE, "odd number of arguments", "each key has a value: Dictionary.new(key, value)"),
  MISSING_KEY(KEY_ERROR, "missing key: {key}", "getWithDefault has a value for missing keys"),
  GROUP_OUT_OF_BOUNDS(PRIMITIVE, "out of bound index: {index}"),
  REGULAR_EXPRESSION(
      PRIMITIVE,
      "invalid regular expression `{text}': {reason}",
      "\\ makes one of ( ) [ ] { } . * + ? | an ordinary character"),
  EMPTY_EXPRESSION(PART, "Empty expression"),
  EXPRESSION_TOO_LONG(PART, "Expression too long"),
  UNMATCHED_PARENTHESIS(PART, "Unmatched marking parenthesis ( or \\(."),
  UNMATCHED_BRACKET(PART, "Unmatched [ or [^."),
  NOTHING_TO_REPEAT(PART, "The repeat operator \"{operator}\" cannot start a regular expression."),
  OTHER_EXPRESSION_ERROR(PART, "{reason}."),
  PLACE_IN_EXPRESSION(
      PART,
      "  The error occurred while parsing the regular expression: '{before}>>>HERE>>>{after}'."),
  FORMAT_WITHOUT_PERCENT(PRIMITIVE, "format does not begin with `%': {text}"),
  FORMAT_WITHOUT_CONVERSION(PRIMITIVE, "format without conversion: {text}"),
  FORMAT_CONVERSION(
      PRIMITIVE,
      "format: \"{character}\" is not a valid conversion type character",
      "%s shows any value, %d an integer, %f and %.2f a number, %% a percent sign"),
  FORMAT_WITHOUT_END(PRIMITIVE, "format without final `|': {text}"),
  FORMAT_NUMBER(PRIMITIVE, "number too large: {digits}"),
  TEXT_AFTER_FORMAT(PRIMITIVE, "unexpected text after the format: {text}"),
  TOO_FEW_FOR_FORMAT(
      PRIMITIVE, "too few arguments for format", "each %s takes an element: \"%s %s\" % [1, 2]"),
  TOO_MANY_FOR_FORMAT(
      PRIMITIVE,
      "too many arguments for format",
      "each element wants a %s of its own: \"%s %s\" % [1, 2]"),
  NOT_A_DATE(
      PRIMITIVE,
      "cannot convert to date: {text}",
      "dates are written as 2026-03-31 or 2026-03-31 12:30:00; Date.now is this moment"),
  YEAR(PRIMITIVE, "Year is out of valid range: 1400..9999"),
  PART_OF_DATE(PRIMITIVE, "{field} is out of range {range}"),
  PART_OF_DATE_NOT_INTEGER(PRIMITIVE, "expected integer, got {value}"),
  DAY_OF_MONTH(PRIMITIVE, "Day of month is not valid for year"),
  MICROSECONDS(PRIMITIVE, "invalid number of microseconds in a day"),

  // ------------------------------------------------------------------ jobs, events, motions

  STACK_EXHAUSTED(SCHEDULING, "stack space exhausted", "a recursion does not end"),
  MEMORY_EXHAUSTED(
      SCHEDULING, "memory exhausted", "URBI_JAVA_OPTS=-Xmx2g gives the kernel 2 GiB of it"),
  NOTHING_CAUGHT(SCHEDULING, "no exception to rethrow", "throw alone is for catch clauses"),
  HELD_TOO_LONG(
      SCHEDULING,
      "{job} has held the kernel for too long",
      "separate statements with ; and not with | so that others have their turn"),
  BUDGET_EXHAUSTED(
      SCHEDULING,
      "the budget of this lobby is exhausted: {limit} {what}",
      "an owner can set another one: lobby.setBudget"),
  WAITS_UNINTERRUPTIBLE(SCHEDULING, "attempt to wait in non-interruptible code"),
  SLEEPS_UNINTERRUPTIBLE(SCHEDULING, "attempt to sleep in non-interruptible code"),
  DEPENDS_UNINTERRUPTIBLE(SCHEDULING, "dependency on other task in non-interruptible code"),
  TIMED_OUT(TIME_OUT, "{timeout} has timed out."),
  SUBSCRIPTION_WITHOUT_FUNCTION(PRIMITIVE, "the subscription has no function of its own"),
  LINK_WITHOUT_TARGET(PRIMITIVE, "the link has no target"),
  JOB_NOT_CLONEABLE(PRIMITIVE, "`Job' objects cannot be cloned"),
  LOBBY_NOT_CLONEABLE(PRIMITIVE, "`Lobby' objects cannot be cloned", "use Lobby.create"),
  NOTHING_TO_RUN(PRIMITIVE, "nothing to run"),
  MISSING_ATTRIBUTE(PRIMITIVE, "missing attribute: {name}"),
  UNKNOWN_TRAJECTORY(
      PRIMITIVE, "unknown trajectory", "it has time, speed, accel, sin, cos or smooth"),
  ATTRIBUTE_NOT_POSITIVE(PRIMITIVE, "{attribute} must be positive"),
  ENDLESS_WAY(PRIMITIVE, "the way to the target is infinitely long"),
  LIMITED(
      WARNING, "{variable}: {value} is {more or less} than {bound}, the {limit}: limited to that"),

  // ------------------------------------------------------------------ files and streams

  NO_FILE(
      FILE_NOT_FOUND,
      "file not found: {name}",
      "it is looked for in System.searchPath, a module in UObject.searchPath"),
  AT_PATH(PRIMITIVE, "{reason}: {path}", "a relative path begins at Directory.current"),
  NO_SUCH_FILE(PART, "no such file or directory"),
  FILE_MISSING(PART, "file does not exist"),
  FILE_EXISTS(PART, "file exists"),
  FILE_TOO_LARGE(PART, "file too large"),
  DIRECTORY_EXISTS(PART, "directory exists"),
  DIRECTORY_MISSING(PART, "directory does not exist"),
  DIRECTORY_NOT_EMPTY(PART, "directory not empty"),
  IS_A_DIRECTORY(PART, "is a directory"),
  IS_THE_ROOT(PART, "is the root directory"),
  PERMISSION_DENIED(PART, "permission denied"),
  TOO_MANY_LINKS(PART, "too many levels of links"),
  INPUT_OUTPUT(PART, "input/output error"),
  REASON(PRIMITIVE, "{reason}"),
  NOT_A_DIRECTORY(PRIMITIVE, "not a directory"),
  NOT_A_FILE(PRIMITIVE, "not a file"),
  NOT_A_PATH(PRIMITIVE, "not a path"),
  IS_A_PROTOTYPE(PRIMITIVE, "{type} is a prototype: use {type}.new"),
  INVALID_PATH(PRIMITIVE, "invalid path: {path}"),
  PATH_TOO_LONG(PRIMITIVE, "path too long: {number} characters"),
  ABSOLUTE_PATH(PRIMITIVE, "Rhs of concatenation is absolute: {path}"),
  NO_SUCH_DIRECTORY(PRIMITIVE, "no such directory: {path}"),
  DOES_NOT_EXIST(PRIMITIVE, "does not exist: {path}"),
  CANNOT_WATCH(PRIMITIVE, "cannot watch directory: {reason}"),
  STREAM_CLOSED(PRIMITIVE, "stream is closed"),
  LOADING(LINE, "loading file: {path}"),

  // ------------------------------------------------------------------ the machine and the network

  INVALID_COMMAND(PRIMITIVE, "invalid command"),
  CANNOT_RUN(PRIMITIVE, "cannot run {program}: {reason}"),
  PROCESS_WITHOUT_PROGRAM(PRIMITIVE, "Process has no program"),
  PROCESS_RUN(PRIMITIVE, "Process was already run", "each run is of a new Process"),
  PROCESS_NOT_RUN(PRIMITIVE, "Process was not run"),
  STATUS_NOT_STARTED(PART, "not started"),
  STATUS_RUNNING(PART, "running"),
  STATUS_EXITED(PART, "exited with status {status}"),
  STATUS_KILLED(PART, "killed by signal {signal}"),
  VARIABLE_NAME(PRIMITIVE, "invalid name of a variable: {name}"),
  VARIABLE_VALUE(PRIMITIVE, "invalid value of a variable"),
  NOT_A_SOCKET(PRIMITIVE, "not a socket"),
  SOCKET_CONNECTED(PRIMITIVE, "socket is already connected"),
  SOCKET_NOT_CONNECTED(PRIMITIVE, "socket not connected"),
  CLOSED(PART, "closed"),
  BROKEN_PIPE(PART, "Broken pipe"),
  CONNECTION_CLOSED(PART, "connection is closed"),
  UNKNOWN_HOST(PART, "unknown host: {host}"),
  INVALID_PORT(PART, "invalid port: {port}"),
  UNKNOWN_SERVICE(PART, "service not found: {name}"),
  NOT_A_SERVER(PRIMITIVE, "not a server"),
  SERVER_LISTENING(PRIMITIVE, "server is already listening"),
  SERVER_NOT_LISTENING(PRIMITIVE, "server not listening"),
  NOT_POSSIBLE(PRIMITIVE, "not possible here"),
  LOGGER_UNDEFINED(PRIMITIVE, "category or level undefined"),

  // ------------------------------------------------------------------ what is not allowed

  NO_SUCH_BUDGET(PRIMITIVE, "no such part of a budget: {word}"),
  NO_BUDGET(PART, "no part of a budget: {text}"),
  OF_JOBS(PART, "jobs"),
  OF_TIMERS(PART, "timers"),
  OF_PROCESSES(PART, "processes"),
  OF_OUTPUT(PART, "bytes of unread output"),
  OF_INPUT(PART, "bytes of unfinished input"),
  OF_TIME(PART, "% of the kernel's time"),
  OF_HOLD(PART, "ms without letting others run"),
  OF_MEMORY(PART, "bytes allocated without letting others run"),
  OF_DEPTH(PART, "nested calls"),
  NEGATIVE_BUDGET(PRIMITIVE, "expected a limit of 0 or more"),
  NEEDS_ROLE(PRIMITIVE, "this needs the role {needed}, and this lobby has the role {own}"),
  CHANGES_FOREIGN(
      PRIMITIVE,
      "changing what is not its own needs the role {needed}, and this lobby has the role {own}"),
  CHANGES_SYSTEM(
      PRIMITIVE,
      "changing what belongs to the system needs the role {needed},"
          + " and this lobby has the role {own}"),
  CHANGES_LOBBY(
      PRIMITIVE,
      "changing what belongs to another lobby needs the role {needed},"
          + " and this lobby has the role {own}"),
  CHANGES_JOB(
      PRIMITIVE,
      "changing a job of another lobby needs the role {needed},"
          + " and this lobby has the role {own}"),
  CONFINED_DIRECTORY(PART, "is the directory of this kernel"),
  CONFINED_FILES(PART, "files are not allowed to this lobby"),
  CONFINED_OUTSIDE(PART, "outside of the directory of this kernel"),
  CONFINED_PROCESSES(PART, "processes are not allowed in this kernel"),
  CONFINED_MODULES(PART, "modules are not allowed in this kernel"),
  CONFINED_CONNECTIONS(PART, "connections are not allowed in this kernel"),

  // ------------------------------------------------------------------ components

  NOT_A_UOBJECT(PRIMITIVE, "not a UObject"),
  NO_ISOLATION(PART, "this program runs no modules in processes of their own"),
  MODULE_UNLOADED(PART, "the module has been unloaded"),
  MODULE_OPTION(PRIMITIVE, "no option of modules: {option} (there is: isolate)"),
  NOT_LOADED(PRIMITIVE, "not loaded: {module}"),
  NOT_LOADED_HERE(PART, "{module} is not loaded"),
  NOT_LOADED_ANY_MORE(PART, "{module} is not loaded any more"),
  UNREADABLE_MODULE(PRIMITIVE, "cannot read {file}: {reason}"),
  CONSTRUCTION_FAILED(PRIMITIVE, "{class} construction failed: init returned {status}."),
  CAUGHT_IN_COMPONENT(PRIMITIVE, "exception caught while {doing}: {reason}"),
  CAUGHT_IN_THREAD(PART, "Exception in threaded call: {reason}"),
  CAUGHT_IN_NOTIFY(LINE, "Exception caught while processing notify on {variable}:"),
  MISSING_CLASS(PART, "missing class {class}"),
  NAMED_REASON(PART, "{class}: {reason}"),
  FUNCTION_GONE(PRIMITIVE, "{function}: {reason}"),
  OBJECT_DESTROYED(PART, "the object has been destroyed"),
  DESTROYED(PART, "{object} has been destroyed"),
  VARIABLE_WITHOUT_OBJECT(PART, "the object of the variable {variable} has gone"),
  NO_OBJECT_FOR_VARIABLE(PART, "UVar creation on non existing object: {variable}"),
  NO_VARIABLE(PART, "no such variable: {name}"),
  IN_REPLAY(PART, "in a replay, threads of components have no say"),
  KERNEL_ENDED(PART, "the kernel has ended"),
  WAIT_INTERRUPTED(PART, "interrupted while waiting for the kernel"),
  NO_OBJECT(PART, "no such object: {name}"),
  NO_SERIALIZABLE(PART, "no such class in Serializables: {class}"),
  KEY_NOT_STRING(PART, "Dictionaries exchanged with UObjects can only have String keys: {key}"),
  KEY_OF_TYPE(
      PART, "Dictionaries exchanged with UObjects can only have String keys: {key} ({type})"),
  NESTED_TOO_DEEPLY(PART, "nested too deeply"),
  CAST_TO_UVAR(PART, "invalid cast to UVar from non-string value."),
  NO_VALUE_OF_TYPE(PART, "the value is no {type}"),
  NIL_IS_NO(PART, "nil or void is no {class}"),
  IS_NO(PART, "{value} is no {class}"),
  A_IS_NO(PART, "a {kind} is no {class}"),
  NOTHING_LIKE(PART, "there is nothing like this in urbiscript: {class}"),
  CONTAINS_ITSELF(PART, "a container in itself"),
  CONTAINERS_TOO_DEEP(PART, "containers nested too deeply"),
  PROCESS_GONE(PART, "the remote process has gone"),
  NOT_SENDABLE(PRIMITIVE, "this value cannot be sent to a remote process"),
  WITHOUT_PROTOTYPE(PART, "{name} has no UObject as a prototype"),
  NOT_MADE_IN_TIME(PART, "the remote process has not made the object in {seconds} s"),
  NOT_ACCESSED_IN_TIME(
      PART,
      "the remote process has not set {variable} within {seconds} s of an access: the value is old"),
  NAME_TAKEN(PART, "there is a UObject {name} already", "one process has the class, the first"),
  NOT_ITS_OBJECT(PART, "no such remote object: {name}"),
  NOT_AN_EVENT(PART, "not an event: {name}"),
  NOTHING_EXTERNAL(PART, "no declaration: {kind}"),
  NO_NUMBER_OF_ARGUMENTS(PART, "no number of arguments: {text}"),
  NAME_MISSING(PART, "the name is missing"),
  REJECTED_ARGUMENT(PART, "invalid argument {index}, expected {type}"),
  NO_KIND_OF_FRAME(PART, "no kind of frame: {number}"),
  NO_KIND_OF_PROPERTY(PART, "no property: {name}"),
  NO_KIND_OF_MESSAGE(PART, "no kind of message: {number}"),
  NO_KIND_OF_VALUE(PART, "no kind of value: {number}"),
  SIZES_OF_INTEGERS(PART, "integers of {number} and {number} bytes"),
  LONG_MESSAGE(PART, "a message of more than {number} bytes"),
  LONG_LIST(PART, "a list of {number} elements"),
  VALUES_TOO_DEEP(PART, "values nested too deeply"),
  UNKNOWN_KEYWORDS(PART, "a binary with unknown keywords"),
  PROTOCOL_BROKEN(LINE, "the remote process does not keep to the protocol: {reason}"),
  LONG_FRAME(PART, "a frame of {number} bytes"),
  PROCESS_SILENT(PART, "the remote process does not answer any more"),
  PROCESS_DOES_NOT_READ(PART, "the remote process does not read what it is sent"),
  MODULE_PROCESS_ENDED(PART, "the process of {module} has ended: {reason}"),
  MODULE_NOT_STARTED(PART, "not started within {seconds} s"),
  MODULE_CANNOT_RUN(PART, "cannot be run: {reason}"),
  MODULE_LAST_WORDS(PART, "its last words:"),
  EXIT_STATUS(PART, "exit status {status}"),
  SIGNAL(PART, "signal {number}"),
  DATAGRAMS_NOT_SAFE(PART, "datagrams would not be as safe as this connection"),
  NO_DATAGRAMS(PART, "cannot take datagrams: {reason}"),
  PORT_CLOSED(PART, "the port has been closed"),

  // ------------------------------------------------------------------ clients without a lobby

  CLOSING(LINE, "{reason}: closing"),
  PROTOCOL_VERSIONS(LINE, "this server speaks versions {least} to {most} of the UObject protocol"),
  UOBJECTS_NEED_OWNER(LINE, "to bring UObjects needs the role owner"),
  FOREIGN_PROTOCOL(PART, "this is the console of an Urbi server, which does not speak {protocol}"),
  SPEAKS_TLS(PART, "this server speaks TLS alone (--tls, or URBI_TLS=1 in the environment)"),
  ASKS_FOR_TOKEN(PART, "this server asks for a token (--token FILE)"),
  WRONG_TOKEN(PART, "wrong token"),
  LONG_TOKEN(PART, "this token is too long"),
  TOKEN_TOO_SOON(PART, "after a wrong token, no other one for {seconds} s"),
  MOST_CLIENTS(PART, "this server takes {number} clients at most"),
  NO_DESCRIPTOR(PART, "this server has no file descriptor left for another client"),

  // ------------------------------------------------------------------ lines of their own

  SYNTAX_ERROR(SYNTAX, "{loc}: syntax error: {message}"),
  CALLED_FROM(LINE, "   called from: {place}{name}"),
  LEFT_OUT(PART, "({count} more calls)"),
  INTERRUPTED(LINE, "received interruption, killing foreground job."),
  INTERRUPTED_SHUTDOWN(LINE, "received interruption, shutting down."),
  INTERNAL_ERROR(LINE, "internal error: {failure}", "the log has more; please report it"),
  UNPRINTABLE(LINE, "exception that cannot be shown", "its asString fails"),
  DEPRECATED(WARNING, "`{old}' is deprecated"),
  DEPRECATED_FOR(WARNING, "`{old}' is deprecated, use `{successor}'"),
  HOLDS_KERNEL(
      LINE,
      "{job} has held the kernel for more than {limit} s without letting others run, ending it"),
  FILLS_MEMORY(
      LINE, "{job} has allocated more than {limit} bytes without letting others run, ending it"),
  MEMORY_NEARLY_EXHAUSTED(LINE, "urbi: memory is nearly exhausted, {doing}"),
  MEMORY_GONE(LINE, "urbi: memory exhausted"),
  EVICTING(PART, "ending what is done for {whom}"),
  LETTING_GO(PART, "letting {whom} go"),
  EVICTED(LINE, "{reason}: the jobs of this lobby are ended"),
  LOGS_TOO_MUCH(LINE, "{lobby} logs too much: messages of it are lost from here on"),
  CLIENTS_LOG_TOO_MUCH(
      LINE, "clients log too much together: messages of them are lost from here on"),
  LEFT_BEHIND(LINE, "{reason}: ending what {lobby} has left behind, {count} jobs"),
  EMBEDDING_PROGRAM(PART, "the program that embeds the kernel"),
  COMMON_BUDGET(PART, "clients that have left may have {limit} {what} together"),
  NOBODY_HOLDS(LINE, "nobody holds the kernel"),
  INTERRUPTED_HOLDER(LINE, "interrupted: {job} held the kernel for {time} s"),
  INTERRUPTED_LOBBY(LINE, "interrupted: {lobby}"),
  NO_SUCH_LOBBY(LINE, "no such lobby: {lobby}; there are {others}"),
  MAY_NOT_INTERRUPT(LINE, "to interrupt other lobbies needs the role owner"),
  NO_SUCH_JOB(LINE, "no such job any more: {number}"),
  NO_SUCH_TAG(LINE, "no such tag any more: {number}"),
  BLOCKS_JOB(LINE, "a job can be stopped and frozen; only a tag can be blocked"),
  NO_SUCH_EVENT(LINE, "no such event any more: {number}"),
  NO_SUCH_SLOT(LINE, "no such slot any more: {name}"),
  NO_PAYLOAD(PRIMITIVE, "a payload is expressions, separated by commas"),
  WAS_STOPPED(LINE, "it was stopped before its end"),
  NO_SUCH_CODE(LINE, "no such code runs any more: {number}"),
  ENDED_BY_ERROR(LINE, "an error has ended it"),
  RUNS_NO_CODE(
      LINE, "running code here needs the role {needed}, and this lobby has the role {role}"),
  NO_PATH(LINE, "names of slots with periods between them expected, not {text}"),
  NO_SLOT_AT(LINE, "no such slot: {path}"),
  TOO_MANY_VARIABLES(LINE, "of more than {number} variables nothing is told");

  private final ProblemKind kind;
  private final Template template;
  private final @Nullable String hint;

  Problem(ProblemKind kind, String text) {
    this(kind, text, null);
  }

  Problem(ProblemKind kind, String text, @Nullable String hint) {
    this.kind = kind;
    this.template = new Template(text);
    this.hint = hint;
  }

  /** Whether it is an exception, a warning, a line or a part of another message. */
  public ProblemKind kind() {
    return kind;
  }

  /** Its text, with placeholders. */
  public Template template() {
    return template;
  }

  /** Its text, with the values in place of its placeholders, in order. */
  public String text(Object... values) {
    return template.fill(values);
  }

  /** A hint at what to do about it. */
  public Optional<String> hint() {
    return Optional.ofNullable(hint);
  }
}
