package org.urbi.kernel.library.exception;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.exception.ExceptionTable.ExceptionText;
import org.urbi.kernel.library.exception.ExceptionTable.Init;
import org.urbi.kernel.library.lobby.Warnings;
import org.urbi.kernel.library.object.ObjectType;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.text.StringDistance;

/** The exceptions that the language throws (manual, "Exception"), one row for each type. */
public final class ExceptionTypes {
  private static final String EXCEPTION = "Exception";
  private static final String NOTHING = "Without arguments.";
  private static final String WRONG = "What is wrong.";
  private static final String BAD_NUMBER = "Exception.BadNumber";

  /** The tables, which all kernels share: they need nothing of a kernel. */
  private static final List<BuiltinTable> TABLES = rows();

  private ExceptionTypes() {}

  /** The tables of all types but Exception itself, in alphabetical order. */
  public static List<BuiltinTable> tables() {
    return TABLES;
  }

  private static List<BuiltinTable> rows() {
    return List.of(
        new ExceptionTable(
            "Dictionary.KeyError",
            EXCEPTION,
            "Thrown when a dictionary has no value for a key, which is its slot `key'.",
            null,
            null),
        new ExceptionTable(
            "Exception.Argument",
            EXCEPTION,
            "An argument that could not be used.",
            Init.of(
                "Of that routine, the argument at that index, for that reason.",
                "routine",
                "index",
                "exception"),
            new ExceptionText(
                "The routine, the argument, and the reason.", ExceptionTypes::argument)),
        new ExceptionTable(
            "Exception.ArgumentType",
            "Exception.Type",
            "Deprecated: an argument of the wrong type.",
            new Init(
                "Of that function, at that place, with that value instead of one of that type.",
                List.of("routine", "index", "effective", "expected"),
                ExceptionTypes::initArgumentType),
            new ExceptionText(
                "The function, the place, the value and the type.", ExceptionTypes::argumentType)),
        new ExceptionTable(
            "Exception.Arity",
            EXCEPTION,
            "A call with a wrong number of arguments.",
            new Init(
                "Of that routine, given so many arguments, with these bounds.",
                List.of("routine", "effective", "minimum", "maximum?"),
                ExceptionTypes::initArity),
            new ExceptionText(
                "The routine, how many arguments it expected, how many it was given.",
                ExceptionTypes::arity)),
        new ExceptionTable(
            "Exception.Assertion", EXCEPTION, "A claim that does not hold.", null, null),
        new ExceptionTable(
            "Exception.BadInteger",
            BAD_NUMBER,
            "An integer that a routine cannot use.",
            null,
            new ExceptionText(
                "The routine, and what is wrong with the integer.", ExceptionTypes::badNumber)),
        new ExceptionTable(
            BAD_NUMBER,
            EXCEPTION,
            "A number that a routine cannot use.",
            Init.of(
                "Of that routine, with a format for the message, and the number.",
                "routine",
                "format=fmt",
                "effective"),
            new ExceptionText(
                "The routine, and what is wrong with the number.", ExceptionTypes::badNumber)),
        new ExceptionTable(
            "Exception.Constness",
            EXCEPTION,
            "An attempt to change a constant.",
            Init.of(NOTHING),
            ExceptionText.as(WRONG, Problem.CONSTANT)),
        new ExceptionTable(
            "Exception.FileNotFound",
            EXCEPTION,
            "A file that is not there.",
            Init.of("Of that name.", "name"),
            new ExceptionText(
                "The routine, if any, and the name of the file.", ExceptionTypes::noFile)),
        new ExceptionTable(
            "Exception.ImplicitTagComponent",
            EXCEPTION,
            "An implicit tag under an unknown name.",
            Init.of(NOTHING),
            ExceptionText.as(WRONG, Problem.BAD_IMPLICIT_TAG)),
        new ExceptionTable(
            "Exception.Lookup",
            EXCEPTION,
            "A name that was not found.",
            new Init(
                "Of that name, in that object; whether to look for what was meant.",
                List.of("name", "object", "fixSpelling?"),
                ExceptionTypes::initLookup),
            new ExceptionText(
                "The name that was not found, and the one which may have been meant.",
                ExceptionTypes::lookup)),
        new ExceptionTable(
            "Exception.MatchFailure",
            EXCEPTION,
            "A pattern that did not match.",
            Init.of(NOTHING),
            ExceptionText.as(WRONG, Problem.UNMATCHED)),
        new ExceptionTable(
            "Exception.NegativeNumber",
            BAD_NUMBER,
            "A number that should not be negative.",
            Init.of("Of that routine, and the number.", "routine", "effective"),
            ExceptionText.inRoutine("The routine, and the number.", Problem.NEGATIVE)),
        new ExceptionTable(
            "Exception.NonPositiveNumber",
            BAD_NUMBER,
            "A number that should be positive.",
            Init.of("Of that routine, and the number.", "routine", "effective"),
            ExceptionText.inRoutine("The routine, and the number.", Problem.NOT_POSITIVE)),
        new ExceptionTable(
            "Exception.Primitive",
            EXCEPTION,
            "An error in a routine of the library.",
            Init.of("Of that routine, with that message.", "routine", "message"),
            ExceptionText.as("The routine and the message.", Problem.IN_ROUTINE)),
        new ExceptionTable(
            "Exception.PropertyLookup",
            "Exception.Lookup",
            "A property that was not found.",
            Init.of("Of that name, slot->property, of that object.", "name", "object"),
            ExceptionText.as("The slot and the property.", Problem.PROPERTY_NOT_FOUND)),
        new ExceptionTable(
            "Exception.Redefinition",
            EXCEPTION,
            "A slot that is there already.",
            Init.of("Of the slot of that name.", "name"),
            ExceptionText.as("The name of the slot.", Problem.REDEFINED)),
        new ExceptionTable(
            "Exception.Scheduling", EXCEPTION, "Something went wrong with jobs.", null, null),
        new ExceptionTable(
            "Exception.Syntax",
            EXCEPTION,
            "Source text that does not parse.",
            Init.of(
                "At that place, with that message, in that text.",
                "location=loc",
                "message",
                "input"),
            ExceptionText.as("The place and the message.", Problem.SYNTAX_ERROR)),
        new ExceptionTable(
            "Exception.TimeOut", EXCEPTION, "Code that has taken too much time.", null, null),
        new ExceptionTable(
            "Exception.Type",
            EXCEPTION,
            "A value of another type than expected.",
            Init.of("Of that value, where that type was expected.", "effective", "expected"),
            new ExceptionText("The value, and the type that was expected.", ExceptionTypes::type)),
        new ExceptionTable(
            "Exception.UnexpectedVoid",
            EXCEPTION,
            "A void value where one was needed.",
            Init.of(NOTHING),
            ExceptionText.as(WRONG, Problem.VOID)));
  }

  private static String text(Frame frame, UrbiObject self, String slot) {
    return ExceptionType.text(frame, self, slot);
  }

  /** The number in a slot, or a default when there is none. */
  private static int count(UrbiObject exception, String slot, int otherwise) {
    UrbiObject value = exception.lookup(exception.world().symbol(slot));
    return value instanceof UrbiFloat number ? (int) number.value() : otherwise;
  }

  private static String argument(Frame frame, UrbiObject self) {
    int index = count(self, "index", 0);
    String routine = text(frame, self, "routine");
    String reason = text(frame, self, "exception");
    return index == 0
        ? Problem.WRONG_TARGET.text(routine, reason)
        : Problem.WRONG_ARGUMENT.text(routine, index, reason);
  }

  private static void initArgumentType(
      Frame frame, CallSite site, UrbiObject self, UrbiObject[] arguments) {
    Warnings.deprecated(frame, site, "Exception.ArgumentType", null);
    OwnSlots.put(self, "routine", arguments[0]);
    OwnSlots.put(self, "index", arguments[1]);
    OwnSlots.put(self, "effective", arguments[2]);
    OwnSlots.put(self, "expected", arguments[3]);
  }

  private static String argumentType(Frame frame, UrbiObject self) {
    return Problem.WRONG_ARGUMENT_TYPE.text(
        text(frame, self, "routine"), text(frame, self, "index"), type(frame, self));
  }

  private static void initArity(
      Frame frame, CallSite site, UrbiObject self, UrbiObject[] arguments) {
    OwnSlots.put(self, "routine", arguments[0]);
    OwnSlots.put(self, "effective", arguments[1]);
    OwnSlots.put(self, "minimum", arguments[2]);
    OwnSlots.put(self, "maximum", arguments[arguments.length - 1]);
  }

  private static String arity(Frame frame, UrbiObject self) {
    return Errors.arityText(
        text(frame, self, "routine"),
        count(self, "effective", 0),
        count(self, "minimum", 0),
        count(self, "maximum", Integer.MAX_VALUE));
  }

  private static String noFile(Frame frame, UrbiObject self) {
    String text = Problem.NO_FILE.text(text(frame, self, "name"));
    boolean called = self.lookup(self.world().symbol("routine")) != null;
    return called ? Problem.IN_ROUTINE.text(text(frame, self, "routine"), text) : text;
  }

  private static String badNumber(Frame frame, UrbiObject self) {
    if (self.lookup(self.world().symbol("fmt")) == null) {
      return ExceptionType.asString(frame, self);
    }
    String text = text(frame, self, "fmt").replace("%s", text(frame, self, "effective"));
    String routine = text(frame, self, "routine");
    // An argument exception names the routine itself.
    return routine.isEmpty() ? text : Problem.IN_ROUTINE.text(routine, text);
  }

  private static void initLookup(
      Frame frame, CallSite site, UrbiObject self, UrbiObject[] arguments) {
    if (arguments.length > 2) {
      OwnSlots.put(self, "fixSpelling", arguments[2]);
    }
    OwnSlots.put(self, "object", arguments[1]);
    OwnSlots.put(self, "name", arguments[0]);
  }

  private static String lookup(Frame frame, UrbiObject self) {
    String name = text(frame, self, "name");
    String meant = meant(frame, self, name);
    return meant == null ? Problem.NOT_FOUND.text(name) : Problem.MISSPELLED.text(name, meant);
  }

  private static @Nullable String meant(Frame frame, UrbiObject self, String name) {
    UrbiObject object = self.lookup(self.world().symbol("object"));
    if (object == null || !Truth.of(frame, OwnSlots.get(frame, self, "fixSpelling"))) {
      return null;
    }
    boolean local = self.lookup(self.world().symbol("local")) != null;
    boolean session = object instanceof UrbiLobby;
    StringDistance.ClosestName guess = new StringDistance.ClosestName(name);
    for (UrbiObject holder : local ? List.of(object) : ObjectType.allProtos(object)) {
      for (Symbol slot : holder.localSlotNames()) {
        // Nobody means a name that is not for people, such as $id. Texts are those of 2.7, which
        // had
        // no help.
        if (slot.name().indexOf('$') < 0 && !slot.name().equals("help")) {
          guess.consider(slot.name(), holder == object && !session);
        }
      }
    }
    return guess.meant();
  }

  private static String type(Frame frame, UrbiObject self) {
    UrbiObject effective = self.lookup(self.world().symbol("effective"));
    UrbiObject expected = self.lookup(self.world().symbol("expected"));
    String type =
        expected == null
            ? "Object"
            : frame
                .interpreter()
                .asString(frame, frame.interpreter().send(frame, expected, "type"));
    String shown = effective == null ? "" : frame.interpreter().asPrintable(frame, effective);
    return Problem.WRONG_TYPE.text(shown, Errors.article(type), type);
  }
}
