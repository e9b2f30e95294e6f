package org.urbi.kernel.library.value;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.node.Tuples;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.UrbiTuple;
import org.urbi.kernel.object.Values;
import org.urbi.lang.print.FloatFormat;
import org.urbi.lang.print.StringEscape;

/**
 * How containers are shown: their elements as {@code asPrintable} shows them. A container within
 * itself is shown as {@code [...]}, or {@code (...)}.
 */
public final class Printing {
  /** So many characters are shown between two checks whether to continue. */
  private static final int PIECE = 1 << 14;

  private final Frame caller;
  private final Values values;
  private final Symbol asPrintable;
  private final Symbol asString;
  private final StringBuilder out = new StringBuilder();

  /** The containers around what is being shown. */
  private final Set<UrbiObject> around = Collections.newSetFromMap(new IdentityHashMap<>());

  private Printing(Frame caller) {
    this.caller = caller;
    this.values = caller.interpreter().world().values();
    this.asPrintable = caller.interpreter().world().symbol("asPrintable");
    this.asString = caller.interpreter().world().symbol("asString");
  }

  /** A container as the library's {@code asString} shows it. */
  public static String container(Frame caller, UrbiObject container) {
    Printing printing = new Printing(caller);
    printing.appendContainer(container);
    return printing.out.toString();
  }

  /** A text, however long, as a literal. */
  public static String quoted(Frame caller, String text) {
    Printing printing = new Printing(caller);
    printing.appendQuoted(text);
    return printing.out.toString();
  }

  /** Any value as its {@code asPrintable} shows it. */
  public static String printable(Frame caller, UrbiObject value) {
    Printing printing = new Printing(caller);
    printing.append(value);
    return printing.out.toString();
  }

  private void append(UrbiObject value) {
    caller.job().checkInterrupted();
    if (value instanceof UrbiFloat number && value.shape() == values.floatShape && isPlain(value)) {
      out.append(FloatFormat.format(number.value()));
    } else if (value instanceof UrbiString text && isPlain(value)) {
      appendQuoted(text.value());
    } else if (isContainer(value) && isPlain(value)) {
      appendContainer(value);
    } else {
      out.append(caller.interpreter().asPrintable(caller, value));
    }
  }

  private void appendQuoted(String text) {
    out.append('"');
    int end = 0;
    while (end < text.length()) {
      int begin = end;
      end += Math.min(PIECE, text.length() - begin);
      StringEscape.append(out, text, begin, end, '"');
      caller.job().worked(end - begin);
    }
    out.append('"');
  }

  private boolean isContainer(UrbiObject value) {
    return value instanceof UrbiList
        || value instanceof UrbiTuple
        || value instanceof UrbiDictionary
        || value.lookup(asString) == values.tupleProto.localSlot(asString);
  }

  /** Whether it is shown by the library, and not by functions of a program. */
  private boolean isPlain(UrbiObject value) {
    return isOfLibrary(value.lookup(asPrintable)) && isOfLibrary(value.lookup(asString));
  }

  private static boolean isOfLibrary(@Nullable UrbiObject method) {
    return method instanceof Code && !(method instanceof Function);
  }

  private void appendContainer(UrbiObject container) {
    boolean repeated = !around.add(container);
    if (container instanceof UrbiList list) {
      appendElements("[", list.elements(), "]", repeated);
    } else if (container instanceof UrbiDictionary dictionary) {
      appendEntries(dictionary.sorted(), repeated);
    } else {
      appendTuple(container, repeated);
    }
    if (!repeated) {
      around.remove(container);
    }
  }

  private void appendTuple(UrbiObject tuple, boolean repeated) {
    List<UrbiObject> members = Tuples.members(caller, tuple);
    if (members == null) {
      throw caller.interpreter().errors().argumentType("asString", 0, tuple, values.tupleProto);
    }
    appendElements("(", members, members.size() == 1 ? ",)" : ")", repeated);
  }

  private void appendElements(
      String opening, List<UrbiObject> elements, String closing, boolean repeated) {
    out.append(opening);
    if (repeated) {
      out.append("...").append(closing.substring(closing.length() - 1));
      return;
    }
    boolean first = true;
    for (UrbiObject element : List.copyOf(elements)) {
      out.append(first ? "" : ", ");
      first = false;
      append(element);
    }
    out.append(closing);
  }

  private void appendEntries(
      List<Map.Entry<UrbiDictionary.Key, UrbiObject>> entries, boolean repeated) {
    if (repeated || entries.isEmpty()) {
      out.append(repeated ? "[...]" : "[ => ]");
      return;
    }
    String separator = "[";
    for (Map.Entry<UrbiDictionary.Key, UrbiObject> entry : entries) {
      out.append(separator);
      separator = ", ";
      append(entry.getKey().value());
      out.append(" => ");
      append(entry.getValue());
    }
    out.append("]");
  }
}
