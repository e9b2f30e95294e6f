package org.urbi.kernel.library.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.builtin.Primitive;
import org.urbi.kernel.error.HelpText;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.object.Ancestors;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Utf8Text;

/**
 * Explains a topic, in lines: a type, a slot, a keyword, an option, or an object of the user's. No
 * function is called to find it.
 */
final class Help {
  private static final int WIDTH = 100;

  /** How many slots of an object of the user's are told. */
  private static final int MOST_SLOTS = 200;

  private static final Pattern LINK = Pattern.compile("\\[([^\\]]+)\\]\\([^)\\s]+\\)");

  /** What each class has by itself: {@code asRobot}. */
  private static final Pattern OWN_CONVERSION = Pattern.compile("as[A-Z]\\w*");

  private static final String FENCE = "```";

  /** What a line of Markdown begins with that does not go on with the one before. */
  private static final String BEGINNINGS = "|-*#";

  private final UrbiObject lobby;
  private final Topics topics;
  private final List<String> lines = new ArrayList<>();

  Help(UrbiObject lobby, Topics topics) {
    this.lobby = lobby;
    this.topics = topics;
  }

  /** What can be asked for. */
  List<String> overview() {
    Arrays.stream(HelpText.OVERVIEW.text().split("\n")).forEach(lines::add);
    listed(HelpTexts.types());
    return lines;
  }

  /** What is known of a topic; the names that may be meant, if nothing is. */
  List<String> about(String topic) {
    boolean known =
        aboutSlot(topic)
            || aboutType(topic)
            || aboutPart(HelpTexts.KEYWORDS, topic)
            || aboutPath(topic)
            || aboutAnySlot(topic)
            || aboutOther(topic);
    if (!known) {
      List<String> near = HelpTexts.near(topic, List.copyOf(topics.others().get().keySet()));
      lines.add(
          near.isEmpty()
              ? HelpText.UNKNOWN.text(topic)
              : HelpText.UNKNOWN_BUT.text(topic, String.join(", ", near)));
    }
    return lines;
  }

  /** What is known of a slot of an object. */
  List<String> about(UrbiObject object, String slot) {
    UrbiObject value = object.lookup(object.world().symbol(slot));
    if (value instanceof Function function) {
      aboutFunction(slot, function);
    } else if (!aboutSlotOf(object, slot)) {
      return about(slot);
    }
    return lines;
  }

  /** What is known of an object. */
  List<String> about(UrbiObject object) {
    if (object instanceof Primitive primitive) {
      for (String type : HelpTexts.types()) {
        if (prototype(type).localSlot(symbol(primitive.name())) == primitive
            && aboutPart(type, primitive.name())) {
          return lines;
        }
      }
      wrapped(sentence(primitive));
    } else if (object instanceof Function function) {
      aboutFunction("function", function);
    } else {
      aboutObject(object);
    }
    return lines;
  }

  private boolean aboutType(String topic) {
    String introduction = HelpTexts.introduction(topic);
    if (introduction == null) {
      return false;
    }
    lines.add(topic);
    lines.add("");
    markdown(introduction);
    lines.add("");
    listed(HelpTexts.slots(topic));
    if (!topic.equals(HelpTexts.KEYWORDS)) {
      HelpTexts.slots(topic).stream()
          .filter(slot -> Character.isLetter(slot.charAt(0)))
          .findFirst()
          .ifPresent(slot -> lines.add(HelpText.OF_SLOT.text(topic, slot)));
    }
    return true;
  }

  private boolean aboutSlot(String topic) {
    int dot = topic.lastIndexOf('.', topic.length() - 2);
    String type = dot < 0 ? "" : topic.substring(0, dot);
    return HelpTexts.types().contains(type)
        && aboutSlotOf(prototype(type), topic.substring(dot + 1));
  }

  /** A slot of an object that it has from a type of the library. */
  private boolean aboutSlotOf(UrbiObject object, String slot) {
    for (UrbiObject ancestor : Ancestors.of(object)) {
      String type = typeName(ancestor);
      if (type != null && aboutPart(type, slot)) {
        return true;
      }
    }
    return false;
  }

  private boolean aboutPart(String type, String slot) {
    TypeText.Part part = HelpTexts.slot(type, slot);
    if (part == null) {
      return false;
    }
    boolean keyword = type.equals(HelpTexts.KEYWORDS);
    lines.add(keyword ? String.join(", ", part.names()) : type + "." + slot);
    lines.add("");
    if (!keyword) {
      for (String name : part.names()) {
        if (prototype(type).localSlot(symbol(name)) instanceof Primitive primitive) {
          wrapped(sentence(primitive));
        }
      }
      lines.add("");
    }
    markdown(part.markdown());
    return true;
  }

  private static String sentence(Primitive primitive) {
    return primitive.signature() + ": " + primitive.doc();
  }

  /** A slot that several types have. */
  private boolean aboutAnySlot(String slot) {
    List<String> types = HelpTexts.typesWith(slot);
    if (types.size() == 1) {
      return aboutPart(types.getFirst(), slot);
    }
    if (!types.isEmpty()) {
      lines.add(HelpText.SEVERAL.text(slot));
      listed(types.stream().map(type -> type + "." + slot).toList());
    }
    return !types.isEmpty();
  }

  /** A path of slots: {@code robot.arm.move}. */
  private boolean aboutPath(String topic) {
    UrbiObject owner = null;
    UrbiObject value = lobby;
    String slot = "";
    for (String name : topic.split("\\.", -1)) {
      owner = value;
      slot = name;
      value = owner instanceof Code ? null : owner.lookup(symbol(name));
      if (value == null) {
        return false;
      }
    }
    if (value instanceof Function function) {
      aboutFunction(topic, function);
      return true;
    }
    if (value instanceof Code) {
      return owner != null && aboutSlotOf(owner, slot);
    }
    return aboutObject(value);
  }

  private void aboutFunction(String name, Function function) {
    lines.add(name + parameters(function));
    lines.addAll(CommentAbove.of(function.source().span()));
  }

  /** An object of the user's, by what is its own and what type it comes from. */
  private boolean aboutObject(UrbiObject object) {
    String type = null;
    Set<String> own = new LinkedHashSet<>();
    for (UrbiObject ancestor : Ancestors.of(object)) {
      type = typeName(ancestor);
      if (type != null) {
        break;
      }
      for (Symbol slot : ancestor.localSlotNames()) {
        if (own.size() < MOST_SLOTS && !isOfEveryType(slot.name())) {
          own.add(described(slot.name(), ancestor.lookup(slot)));
        }
      }
    }
    if (own.isEmpty() && type != null) {
      return aboutType(type);
    }
    lines.add(HelpText.OBJECT.text(named(object), type == null ? "Object" : type));
    listed(own);
    return true;
  }

  /** Whether it says only what type an object is of, or is not for people. */
  private static boolean isOfEveryType(String slot) {
    return slot.equals("type") || OWN_CONVERSION.matcher(slot).matches() || slot.indexOf('$') >= 0;
  }

  private static String described(String name, @Nullable UrbiObject value) {
    return value instanceof Function function ? name + parameters(function) : name;
  }

  /** The parameters of a function, in parentheses; nothing for a lazy function. */
  private static String parameters(Function function) {
    return function.source().formals() == null
        ? ""
        : Utf8Text.toUrbi("(" + function.parameters() + ")");
  }

  private String named(UrbiObject object) {
    return object.lookup(symbol("type")) instanceof UrbiString type ? type.value() : "Object";
  }

  private boolean aboutOther(String topic) {
    Map<String, String> others = topics.others().get();
    String text = others.get(topic);
    if (text != null) {
      text.lines().map(Utf8Text::toUrbi).forEach(lines::add);
    }
    return text != null;
  }

  // ------------------------------------------------------------------ objects and types

  private Symbol symbol(String name) {
    return lobby.world().symbol(name);
  }

  private UrbiObject prototype(String type) {
    return lobby.world().prototype(type);
  }

  private @Nullable String typeName(UrbiObject object) {
    return HelpTexts.types().stream()
        .filter(type -> prototype(type) == object)
        .findFirst()
        .orElse(null);
  }

  // ------------------------------------------------------------------ lines

  /** Names in lines of a width that can be read. */
  private void listed(Collection<String> names) {
    StringBuilder line = new StringBuilder();
    for (String name : names) {
      if (!line.isEmpty() && line.length() + name.length() + 2 > WIDTH) {
        lines.add(line.append(',').toString());
        line.setLength(0);
      }
      line.append(line.isEmpty() ? "  " : ", ").append(name);
    }
    if (!line.isEmpty()) {
      lines.add(line.toString());
    }
  }

  private void markdown(String text) {
    boolean code = false;
    StringBuilder paragraph = new StringBuilder();
    for (String line : text.lines().toList()) {
      boolean fence = line.startsWith(FENCE);
      boolean prose = !code && !fence && !line.isBlank();
      if (!paragraph.isEmpty() && (!prose || BEGINNINGS.indexOf(line.charAt(0)) >= 0)) {
        wrapped(paragraph.toString());
        paragraph.setLength(0);
      }
      if (prose) {
        paragraph
            .append(paragraph.isEmpty() ? "" : " ")
            .append(LINK.matcher(line).replaceAll("$1"));
      } else if (!fence) {
        lines.add(Utf8Text.toUrbi(code ? "    " + line : ""));
      }
      code ^= fence;
    }
    if (!paragraph.isEmpty()) {
      wrapped(paragraph.toString());
    }
  }

  /** A paragraph in lines of a width that can be read. */
  private void wrapped(String paragraph) {
    int begin = 0;
    while (paragraph.length() - begin > WIDTH) {
      int space = paragraph.lastIndexOf(' ', begin + WIDTH);
      if (space <= begin) {
        break;
      }
      lines.add(Utf8Text.toUrbi(paragraph.substring(begin, space)));
      begin = space + 1;
    }
    lines.add(Utf8Text.toUrbi(paragraph.substring(begin)));
  }
}
