package org.urbi.kernel;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.Hint;
import org.urbi.kernel.error.ProblemKind;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.lang.advice.Advice;
import org.urbi.lang.source.Span;

/**
 * What to do about an exception, as far as its slots and the code around its place tell. Runs no
 * code of users: asked for when something has already gone wrong.
 */
final class ErrorAdvice {
  /** How far around a place is looked: a program may be one long line. */
  private static final int LOOK_AROUND = 16;

  private static final Pattern ASSIGNED = Pattern.compile("\\s*=(?![=>])");

  /** {@code for (x in list)}. */
  private static final Pattern LOOP = Pattern.compile("\\bfor(each)?\\s*\\(\\s*$");

  private static final Pattern CATCH = Pattern.compile("\\bcatch\\s*\\(\\s*$");

  /** {@code load(file.u)}. */
  private static final Pattern LOAD = Pattern.compile("\\b(load\\w*|require(File)?)\\s*\\(\\s*$");

  private static final Pattern MADE = Pattern.compile("\\b(\\w+)\\.new\\b");

  /** {@code this.x}, of which the last is missing. */
  private static final Pattern SLOT = Pattern.compile("\\w+(\\.\\w+)+");

  /** {@code Math.sin(…)}. */
  private static final Pattern MATH = Pattern.compile("Math\\s*\\.\\s*\\w+\\b.*", Pattern.DOTALL);

  private static final Pattern CALL = Pattern.compile("\\s*\\(");

  /** What is before an argument. */
  private static final Pattern ARGUMENT = Pattern.compile("[(,]\\s*$");

  private static final Pattern SUFFIX = Pattern.compile("\\.u\\b");

  /** {@code e!}, {@code e?}, of what should be an event. */
  private static final Pattern AS_EVENT = Pattern.compile("\\s*(!(?!=)|\\?)");

  private static final String OF_TAGS = "stop|freeze|unfreeze|block|unblock";

  /** {@code t.stop}, of what should be a tag. */
  private static final Pattern AS_TAG = Pattern.compile("\\s*\\.\\s*(" + OF_TAGS + ")\\b");

  /** {@code a.b.f(…)}: what was asked for {@code f}. */
  private static final Pattern RECEIVER =
      Pattern.compile("((?:\\w+\\.)+)\\w+\\s*(?:\\(.*)?", Pattern.DOTALL);

  private static final Pattern DURATION = Pattern.compile("[0-9.]+(d|h|min|s|ms|us|ns)");

  private static final Pattern LOOPED = Pattern.compile("\\s+in\\b");

  private final Interpreter interpreter;
  private final UrbiLobby lobby;
  private final UrbiException thrown;

  private ErrorAdvice(Interpreter interpreter, UrbiLobby lobby, UrbiException thrown) {
    this.interpreter = interpreter;
    this.lobby = lobby;
    this.thrown = thrown;
  }

  static Advice of(Interpreter interpreter, UrbiLobby lobby, UrbiException thrown) {
    String own = thrown.hint().orElse(null);
    String found = new ErrorAdvice(interpreter, lobby, thrown).hint();
    return Advice.of(found == null ? own : found);
  }

  /** The name that the session lacks, if that is what has gone wrong, or null. */
  static @Nullable String missing(Interpreter interpreter, UrbiLobby lobby, UrbiException thrown) {
    var advice = new ErrorAdvice(interpreter, lobby, thrown);
    return interpreter.errors().is(thrown.value(), ProblemKind.LOOKUP)
            && advice.slot("object") instanceof UrbiLobby
        ? advice.text("name")
        : null;
  }

  private @Nullable String hint() {
    Errors errors = interpreter.errors();
    UrbiObject value = thrown.value();
    if (errors.is(value, ProblemKind.PROPERTY_LOOKUP)) {
      return follows(CALL) ? Hint.NOT_AN_ARROW.text(slotOfProperty()) : null;
    } else if (errors.is(value, ProblemKind.LOOKUP)) {
      return lookup(text("name"), slot("object"));
    } else if (errors.is(value, ProblemKind.ARITY)) {
      return arity(text("routine"));
    } else if (errors.is(value, ProblemKind.ARGUMENT)) {
      UrbiObject cause = slot("exception");
      return cause == null ? null : argument(slot(cause, "effective"), slot(cause, "expected"));
    } else if (errors.is(value, ProblemKind.TYPE)) {
      return type(slot("effective"), slot("expected"));
    }
    return value.isA(interpreter.world().prototype("Exception")) ? null : Hint.NO_EXCEPTION.text();
  }

  private @Nullable String lookup(String name, @Nullable UrbiObject asked) {
    String type = asked == null ? "" : typeName(asked);
    String ofType = ForeignNames.meant(name, type);
    String meant = ForeignNames.meant(name);
    if (ofType != null) {
      return Hint.FOREIGN_SLOT.text(type, name, ofType);
    } else if (meant != null) {
      return Hint.FOREIGN_NAME.text(name, meant);
    } else if (asked == null) {
      return null;
    } else if (asked == interpreter.values().nil) {
      return Hint.ASKED_OF_NIL.text(name);
    } else if (name.equals("'n")) {
      String slot = thrown.span() == null ? "x'n" : thrown.span().text();
      slot = slot.substring(0, slot.length() - (slot.endsWith(name) ? name.length() : 0));
      return Hint.NO_RANGE.text(slot, slot, slot, slot);
    } else if (name.startsWith("'")) {
      return Hint.PRIME.text();
    } else if (isOfSession(name, asked)) {
      return Hint.OF_SESSION.text(name, name);
    } else if (follows(ASSIGNED)) {
      return undeclared(name, asked);
    } else if (follows(LOOPED) && precedes(LOOP)) {
      return Hint.FOR_IN.text(name);
    } else if (precedes(CATCH)) {
      return Hint.CAUGHT.text(name);
    } else if (precedes(LOAD) && follows(SUFFIX)) {
      return Hint.FILE_NAME.text();
    } else if (begins("'")) {
      return Hint.SINGLE_QUOTES.text();
    } else if (asked instanceof UrbiLobby) {
      Span declared = lobby.failures().localOf(name);
      if (declared != null) {
        return Hint.LOCAL_NAME.text(name, declared.location());
      }
      String lower = name.toLowerCase(Locale.ROOT);
      if (!lower.equals(name) && slot(lobby, lower) != null) {
        return Hint.LETTER_CASE.text(lower);
      }
      return unknown(name);
    }
    return name.equals("emit")
        ? Hint.NO_EVENT.text()
        : name.equals("stop") ? Hint.NO_TAG_TO_STOP.text() : askedOf(name, asked);
  }

  /** A name that gets a value without having been declared. */
  private String undeclared(String name, UrbiObject asked) {
    if (isWhole(SLOT)) {
      String owner = spanText().substring(0, spanText().length() - name.length() - 1);
      return asked instanceof UrbiDictionary
          ? Hint.DICTIONARY_SET.text(owner, name)
          : Hint.UNDECLARED_SLOT.text(spanText());
    }
    return asked instanceof UrbiLobby
        ? Hint.UNDECLARED.text(name)
        : Hint.UNDECLARED_THERE.text(name, name);
  }

  /** A name that the session lacks. */
  private String unknown(String name) {
    if (follows(AS_EVENT)) {
      return Hint.UNDECLARED_EVENT.text(name, name);
    } else if (follows(AS_TAG)) {
      return Hint.UNDECLARED_TAG.text(name, name, name);
    } else if (name.matches(OF_TAGS)) {
      return Hint.TAG_FUNCTION.text(name, name);
    }
    return !name.isEmpty() && Character.isUpperCase(name.charAt(0))
        ? Hint.UNKNOWN_CLASS.text(name)
        : (isCall(name) ? Hint.UNKNOWN_FUNCTION : Hint.UNKNOWN_NAME).text(name, name);
  }

  private @Nullable String askedOf(String name, UrbiObject asked) {
    String type = typeName(asked);
    if (asked instanceof UrbiDictionary dictionary && hasKey(dictionary, name)) {
      return Hint.DICTIONARY_KEY.text(name);
    } else if (name.equals("()")) {
      return Hint.NAMELESS_CALL.text();
    } else if (asked.isA(interpreter.world().prototype("Enumeration"))) {
      return Hint.ENUMERATED.text(name, type, type);
    }
    return type.isEmpty() ? null : Hint.ASKED_OF.text(name, Errors.article(type), type);
  }

  private static boolean hasKey(UrbiDictionary dictionary, String name) {
    return dictionary.entries().keySet().stream()
        .anyMatch(key -> key.value() instanceof UrbiString text && text.value().equals(name));
  }

  /** What follows the arrow in {@code o->f}. */
  private String slotOfProperty() {
    String text = spanText();
    return text.substring(text.lastIndexOf('>') + 1).strip();
  }

  /** Whether the session has a slot of which code has asked another {@code this}. */
  private boolean isOfSession(String name, UrbiObject asked) {
    return !(asked instanceof UrbiLobby) && begins(name) && slot(lobby, name) != null;
  }

  private boolean isCall(String name) {
    return begins(name + "(");
  }

  private boolean begins(String text) {
    return spanText().startsWith(text);
  }

  /** The code at the place; empty where that is not known. */
  private String spanText() {
    return thrown.span() == null ? "" : thrown.span().text();
  }

  /** Whether the text at the place is so. */
  private boolean isWhole(Pattern pattern) {
    return pattern.matcher(spanText()).matches();
  }

  /** Whether the text behind the place begins so. */
  private boolean follows(Pattern pattern) {
    Span span = thrown.span();
    if (span == null) {
      return false;
    }
    String text = span.source().text();
    int end = Math.min(span.end(), text.length());
    return pattern
        .matcher(text.substring(end, Math.min(end + LOOK_AROUND, text.length())))
        .lookingAt();
  }

  /** Whether the text before the place ends so. */
  private boolean precedes(Pattern pattern) {
    Span span = thrown.span();
    if (span == null) {
      return false;
    }
    int begin = Math.min(span.begin(), span.source().text().length());
    return pattern
        .matcher(span.source().text().substring(Math.max(0, begin - LOOK_AROUND), begin))
        .find();
  }

  private @Nullable String arity(String routine) {
    if (routine.equals("print")) {
      return Hint.SHOW.text();
    }
    UrbiObject called = called(routine);
    if (called instanceof UrbiEvent) {
      return Hint.EMIT.text(routine);
    }
    if (routine.equals("new")) {
      return init();
    }
    if (routine.equals("sort")) {
      return Hint.COMPARES.text();
    }
    if (routine.equals("join")) {
      return Hint.JOIN.text();
    }
    if (isWhole(MATH) && slot("maximum") instanceof UrbiFloat most) {
      int count = (int) most.value();
      return Hint.NUMBERS.text(routine, count, count == 1 ? "" : "s");
    }
    if (spanText().equals(routine) && precedes(ARGUMENT)) {
      return Hint.CALLED_BY_NAME.text(routine);
    }
    if (slot("maximum") instanceof UrbiFloat most && most.value() == 0) {
      return called != null && typeName(called).equals(routine)
          ? made(called, routine)
          : Hint.NO_ARGUMENTS.text(routine);
    } else if (called instanceof Function function) {
      return Hint.PARAMETERS.text(routine, function.parameters());
    }
    return spanText().endsWith(routine) ? Hint.WITHOUT_ARGUMENTS.text(routine) : null;
  }

  /** {@code Exception("…")}. */
  private String made(UrbiObject called, String name) {
    return called == interpreter.values().floatProto
        ? Hint.TO_NUMBER.text()
        : called == interpreter.values().stringProto
            ? Hint.TO_STRING.text()
            : Hint.NEW.text(name, name);
  }

  /** What was called, as far as the slots of what plain names stand for tell; null if unknown. */
  private @Nullable UrbiObject called(String routine) {
    Matcher receiver = RECEIVER.matcher(spanText());
    UrbiObject object = lobby;
    if (receiver.matches()) {
      for (String name : receiver.group(1).split("\\.")) {
        object = object == null ? null : slot(object, name);
      }
    }
    return object == null ? null : slot(object, routine);
  }

  /** What a class of the session that was to be cloned wants to know. */
  private @Nullable String init() {
    Matcher made = MADE.matcher(spanText());
    UrbiObject cloned = made.find() ? slot(lobby, made.group(1)) : null;
    return cloned != null && slot(cloned, "init") instanceof Function init
        ? Hint.INIT.text(made.group(1), init.parameters())
        : cloned != null && slot("maximum") instanceof UrbiFloat most && most.value() == 0
            ? Hint.NO_INIT.text(made.group(1))
            : null;
  }

  private @Nullable String argument(@Nullable UrbiObject effective, @Nullable UrbiObject expected) {
    String routine = text("routine");
    boolean adds = routine.equals("append") || routine.equals("+=");
    return adds && expected == interpreter.values().listProto
        ? Hint.ADD_ELEMENT.text(routine)
        : routine.equals("echo") && expected == interpreter.values().stringProto
            ? Hint.ONE_VALUE.text()
            : type(effective, expected);
  }

  private @Nullable String type(@Nullable UrbiObject effective, @Nullable UrbiObject expected) {
    if (expected == null || effective == null) {
      return null;
    }
    if (expected == interpreter.values().floatProto && effective instanceof UrbiString text) {
      return DURATION.matcher(text.value()).matches()
          ? Hint.DURATION.text(text.value())
          : Hint.TO_NUMBER.text();
    } else if (expected == interpreter.values().stringProto) {
      return Hint.TO_STRING.text();
    }
    if (expected == interpreter.values().listProto) {
      return Hint.TO_LIST.text();
    }
    return expected == interpreter.prototypes().tag ? Hint.NO_TAG.text() : null;
  }

  private String typeName(UrbiObject of) {
    return slot(of, "type") instanceof UrbiString name ? name.value() : "";
  }

  private String text(String slot) {
    return slot(slot) instanceof UrbiString text ? text.value() : "";
  }

  private @Nullable UrbiObject slot(String name) {
    return slot(thrown.value(), name);
  }

  private @Nullable UrbiObject slot(UrbiObject of, String name) {
    return of.lookup(interpreter.world().symbol(name));
  }
}
