package org.urbi.kernel.library.exception;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.Role;

/** One type of exceptions: how it is made, and how it is shown. */
final class ExceptionTable extends BuiltinTable {
  /** The action of its {@code init}; the number of arguments has been checked. */
  interface Action {
    void run(Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments);
  }

  /** The text of its {@code asString}. */
  interface Text {
    String of(Frame frame, UrbiObject self);
  }

  /**
   * How it is made.
   *
   * @param formals the arguments; optional ones end with {@code ?}
   */
  record Init(String doc, List<String> formals, Action action) {
    /** Keeps each argument in the slot of that name, or of another: {@code format=fmt}. */
    static Init of(String doc, String... slots) {
      List<String> formals = new ArrayList<>();
      List<String> names = new ArrayList<>();
      for (String slot : slots) {
        formals.add(slot.replaceFirst("=.*", ""));
        names.add(slot.replaceFirst(".*=", ""));
      }
      return new Init(
          doc,
          formals,
          (caller, site, self, arguments) -> {
            for (int i = 0; i < arguments.length; i++) {
              OwnSlots.put(self, names.get(i), arguments[i]);
            }
          });
    }

    private Entry entry() {
      int least = (int) formals.stream().filter(formal -> !formal.endsWith("?")).count();
      String shown = formals.isEmpty() ? "" : "(" + String.join(", ", formals) + ")";
      return new Entry(
          "init", least, formals.size(), false, false, Role.OBSERVER, true, shown, "", doc);
    }
  }

  /** How it is shown. */
  record ExceptionText(String doc, Text text) {
    /** The text of a problem, whose places are slots of the exception. */
    static ExceptionText as(String doc, Problem problem) {
      return new ExceptionText(doc, (frame, self) -> filled(frame, self, problem));
    }

    /** The name of the routine that has thrown it, then the text of a problem. */
    static ExceptionText inRoutine(String doc, Problem problem) {
      return new ExceptionText(
          doc,
          (frame, self) ->
              Problem.IN_ROUTINE.text(
                  ExceptionType.text(frame, self, "routine"), filled(frame, self, problem)));
    }

    private static String filled(Frame frame, UrbiObject self, Problem problem) {
      return problem.text(
          problem.template().places().stream()
              .map(slot -> ExceptionType.text(frame, self, slot))
              .toArray());
    }

    private Entry entry() {
      return new Entry("asString", 0, 0, false, false, Role.OBSERVER, false, "", "String", doc);
    }
  }

  private final @Nullable Init init;
  private final @Nullable ExceptionText shown;

  /**
   * @param init null for the one it inherits
   * @param shown null for the text it inherits
   */
  ExceptionTable(
      String type, String proto, String doc, @Nullable Init init, @Nullable ExceptionText shown) {
    super(type, doc, new String[] {proto}, entries(init, shown));
    this.init = init;
    this.shown = shown;
  }

  private static Entry[] entries(@Nullable Init init, @Nullable ExceptionText shown) {
    List<Entry> entries = new ArrayList<>();
    if (init != null) {
      entries.add(init.entry());
    }
    if (shown != null) {
      entries.add(shown.entry());
    }
    return entries.toArray(Entry[]::new);
  }

  @Override
  public UrbiObject call(
      int index, Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments) {
    var values = caller.interpreter().values();
    if (index == 0 && init != null) {
      init.action.run(caller, site, self, arguments);
      return values.voidObject;
    }
    return values.string(
        ExceptionType.placed(
            caller, self, requireNonNull(shown, "declared only then").text.of(caller, self)));
  }
}
