package org.urbi.ros.message;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * Finds types by their names: in the user's folders first, then among the interfaces that this
 * module brings. Files are read each time, so that what has been changed is seen.
 */
public final class Definitions {
  /** More parts than this no message has that a person has thought of: it would fill the memory. */
  private static final long MAX_PARTS = 1 << 22;

  private final Dialect dialect;
  private final InterfaceFiles files;

  /**
   * @param files where the texts are
   */
  public Definitions(Dialect dialect, InterfaceFiles files) {
    this.dialect = dialect;
    this.files = files;
  }

  /** For which ROS the types are. */
  public Dialect dialect() {
    return dialect;
  }

  /**
   * A message by its name, {@code std_msgs/String} or {@code std_msgs/msg/String}.
   *
   * @throws DefinitionException if there is none, or its text, or that of a message in it, is not
   *     right
   */
  public MessageType message(String name) {
    return message(TypeName.parse(name, TypeName.Kind.MESSAGE));
  }

  /**
   * A message.
   *
   * @throws DefinitionException as for {@link #message(String)}
   */
  public MessageType message(TypeName name) {
    return link(DefinitionReader.read(name, dialect, text(name)), Map.of());
  }

  /**
   * A service by its name, {@code std_srvs/Trigger} or {@code std_srvs/srv/Trigger}.
   *
   * @throws DefinitionException as for {@link #message(String)}
   */
  public ServiceType service(String written) {
    TypeName name = TypeName.parse(written, TypeName.Kind.SERVICE);
    List<String> parts = DefinitionReader.parts(name, text(name), 2);
    Map<TypeName, MessageDefinition> own = new LinkedHashMap<>();
    add(own, DefinitionReader.read(name.derived("_Request"), dialect, parts.get(0)));
    add(own, DefinitionReader.read(name.derived("_Response"), dialect, parts.get(1)));
    if (dialect == Dialect.ROS_1) {
      // Nothing is derived there: a request and a response, and that is it.
      MessageType request = link(own.get(name.derived("_Request")), own);
      return new ServiceType(
          new MessageType(
              new MessageDefinition(name, dialect, List.of(), List.of(), text(name)),
              new TreeMap<>()),
          request,
          link(own.get(name.derived("_Response")), own));
    }
    add(own, Derived.event(name));
    add(own, Derived.service(name));
    return service(name, own);
  }

  private ServiceType service(TypeName name, Map<TypeName, MessageDefinition> own) {
    return new ServiceType(
        link(known(own, name), own),
        link(known(own, name.derived("_Request")), own),
        link(known(own, name.derived("_Response")), own));
  }

  /**
   * An action by its name, {@code test_msgs/Fibonacci} or {@code test_msgs/action/Fibonacci}.
   *
   * @throws DefinitionException as for {@link #message(String)}
   */
  public ActionType action(String written) {
    TypeName name = TypeName.parse(written, TypeName.Kind.ACTION);
    return dialect == Dialect.ROS_1 ? actionOfOne(name) : actionOfTwo(name);
  }

  /** Of the file of the action, or of the messages that were made of it. */
  private ActionType.One actionOfOne(TypeName name) {
    Map<TypeName, MessageDefinition> own = new LinkedHashMap<>();
    List<TypeName> names = Derived.messagesOfOne(name);
    if (files.find(dialect, names.getFirst()) == null) {
      List<String> parts = DefinitionReader.parts(name, text(name), names.size());
      for (int i = 0; i < names.size(); i++) {
        add(own, DefinitionReader.read(names.get(i), dialect, parts.get(i)));
      }
    }
    List<MessageType> plain = names.stream().map(each -> linked(each, own)).toList();
    List<MessageType> sent =
        Derived.topicsOfOne(name).stream().map(each -> link(each, own)).toList();
    return new ActionType.One(
        name, plain.get(0), plain.get(1), plain.get(2), sent.get(0), sent.get(1), sent.get(2));
  }

  private MessageType linked(TypeName name, Map<TypeName, MessageDefinition> own) {
    MessageDefinition known = own.get(name);
    return known != null ? link(known, own) : message(name);
  }

  private ActionType.Two actionOfTwo(TypeName name) {
    List<String> parts = DefinitionReader.parts(name, text(name), 3);
    Map<TypeName, MessageDefinition> own = new LinkedHashMap<>();
    List<String> suffixes = List.of("_Goal", "_Result", "_Feedback");
    for (int i = 0; i < suffixes.size(); i++) {
      add(own, DefinitionReader.read(name.derived(suffixes.get(i)), dialect, parts.get(i)));
    }
    Derived.ofAction(name).forEach(each -> add(own, each));
    add(own, Derived.action(name));
    return new ActionType.Two(
        link(known(own, name), own),
        link(known(own, name.derived("_Goal")), own),
        link(known(own, name.derived("_Result")), own),
        link(known(own, name.derived("_Feedback")), own),
        service(name.derived("_SendGoal"), own),
        service(name.derived("_GetResult"), own),
        link(known(own, name.derived("_FeedbackMessage")), own));
  }

  private static void add(Map<TypeName, MessageDefinition> all, MessageDefinition definition) {
    all.put(definition.name(), definition);
  }

  private static MessageDefinition known(Map<TypeName, MessageDefinition> all, TypeName name) {
    MessageDefinition found = all.get(name);
    if (found == null) {
      throw new DefinitionException("there is no " + name);
    }
    return found;
  }

  private String text(TypeName name) {
    String found = files.find(dialect, name);
    if (found == null) {
      throw new DefinitionException(
          "there is no type "
              + name.in(dialect)
              + ": looked for "
              + name
              + "."
              + name.kind().folder()
              + " in "
              + files.describe(dialect));
    }
    return found;
  }

  /**
   * Looks up all that a message consists of.
   *
   * @param own what has no file of its own
   */
  private MessageType link(
      @Nullable MessageDefinition definition, Map<TypeName, MessageDefinition> own) {
    if (definition == null) {
      throw new DefinitionException("a part of a service is missing");
    }
    return link(
        definition,
        name -> {
          MessageDefinition known = own.get(name);
          return known != null ? known : DefinitionReader.read(name, dialect, text(name));
        });
  }

  /** Where a definition comes from. */
  interface Source {
    MessageDefinition get(TypeName name);
  }

  /** Collects all that a message consists of. */
  static MessageType link(MessageDefinition definition, Source source) {
    SortedMap<TypeName, MessageDefinition> found = new TreeMap<>();
    Deque<MessageDefinition> left = new ArrayDeque<>(List.of(definition));
    while (!left.isEmpty()) {
      MessageDefinition next = left.remove();
      for (Field field : next.fields()) {
        FieldType element =
            field.type() instanceof FieldType.Array array ? array.element() : field.type();
        if (element instanceof FieldType.Nested(TypeName name)
            && !name.equals(definition.name())
            && !found.containsKey(name)) {
          MessageDefinition part = source.get(name);
          found.put(name, part);
          left.add(part);
        }
      }
    }
    MessageType type = new MessageType(definition, found);
    parts(type, definition, new TreeMap<>());
    return type;
  }

  /** How many values a message has at least, which must be finite. */
  private static long parts(
      MessageType type, MessageDefinition definition, Map<TypeName, Long> known) {
    Long found = known.get(definition.name());
    if (found != null) {
      if (found < 0) {
        throw new DefinitionException(definition.name() + " contains itself");
      }
      return found;
    }
    known.put(definition.name(), -1L);
    long sum = 1;
    for (Field field : definition.fields()) {
      FieldType element = field.type();
      long times = 1;
      if (element instanceof FieldType.Array array) {
        times = array.length() == FieldType.Length.FIXED ? array.size() : 0;
        element = array.element();
      }
      long each =
          element instanceof FieldType.Nested(TypeName name)
              ? parts(type, type.definition(name), known)
              : 1;
      sum += times * each;
      if (sum > MAX_PARTS) {
        throw new DefinitionException(
            definition.name() + " has more than " + MAX_PARTS + " values");
      }
    }
    known.put(definition.name(), sum);
    return sum;
  }
}
