package org.urbi.ros.two;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.ParameterDescription;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/**
 * The parameters of this node, of which others are told on {@code /parameter_events}. Those that
 * others set are checked against what is said of them.
 */
final class OwnParameters {
  /** More are not kept: others may not declare any. */
  private static final int MOST = 10_000;

  private static final Qos EVENTS = new Qos(true, false, 1000, Qos.DEFAULT.deadline(), false);

  /** What happens to parameters, by the names that the events have for it. */
  private enum Change {
    NEW("new_parameters"),
    CHANGED("changed_parameters"),
    DELETED("deleted_parameters");

    final String field;

    Change(String field) {
      this.field = field;
    }
  }

  /** A parameter. */
  record Parameter(ParameterKind kind, UValue value, ParameterDescription description) {}

  private final TwoHost node;
  private final MessageType valueType;
  private final Publisher events;
  private final BiConsumer<String, UValue> set;
  private final List<BiConsumer<String, UValue>> listeners = new CopyOnWriteArrayList<>();
  private final Map<String, Parameter> parameters = new TreeMap<>();

  /**
   * @param set is told each parameter that is set, whoever has done it
   */
  OwnParameters(TwoHost node, BiConsumer<String, UValue> set) {
    this.node = node;
    this.set = set;
    valueType = node.definitions().message("rcl_interfaces/ParameterValue");
    events =
        node.advertise(
            "/parameter_events",
            node.definitions().message("rcl_interfaces/ParameterEvent"),
            EVENTS,
            new Publisher.Listener() {});
  }

  /** Has a listener told what others have set. */
  void watch(BiConsumer<String, UValue> listener) {
    listeners.add(listener);
  }

  synchronized @Nullable Parameter find(String name) {
    return parameters.get(name);
  }

  synchronized List<String> names() {
    return List.copyOf(parameters.keySet());
  }

  /** The value of one as others see it; one that is not set if there is none. */
  UDictionary message(String name) {
    Parameter known = find(name);
    return known == null
        ? ParameterKind.NOT_SET.message(valueType, new UValue())
        : known.kind.message(valueType, known.value);
  }

  private static String checked(String name) {
    if (name.isBlank() || name.contains(":"))
      throw new RosException("a parameter has a name as speed or wheel.radius, not '" + name + "'");
    return name;
  }

  /**
   * Sets one, as this node may do it.
   *
   * @throws RosException if it is nothing that a parameter can be, or does not fit what is said of
   *     it
   */
  synchronized void set(String name, UValue value) {
    Parameter known = parameters.get(checked(name));
    if (known == null) {
      declare(name, value, ParameterDescription.NONE);
      return;
    }
    boolean isSaid = !known.description.type().isEmpty();
    ParameterKind kind = isSaid || known.kind.fits(value) ? known.kind : ParameterKind.of(value);
    put(name, new Parameter(kind, value, known.description), Change.CHANGED);
  }

  /**
   * Sets one that is not there yet, and says what it is.
   *
   * @throws RosException as for {@link #set}
   */
  synchronized void declare(String name, UValue value, ParameterDescription description) {
    if (parameters.containsKey(checked(name))) return;
    if (parameters.size() >= MOST) throw new RosException("no more than " + MOST + " parameters");
    ParameterKind kind =
        description.type().isEmpty()
            ? ParameterKind.of(value)
            : ParameterKind.of(description.type());
    put(name, new Parameter(kind, value, description), Change.NEW);
  }

  private void put(String name, Parameter next, Change change) {
    String problem = problem(next);
    if (!problem.isEmpty()) throw new RosException(name + ": " + problem);
    parameters.put(name, next);
    tell(change, Map.of(name, next));
    set.accept(name, next.value);
  }

  /** What keeps a parameter from being that; empty if nothing does. */
  private static String problem(Parameter wanted) {
    if (!wanted.kind.fits(wanted.value)) return "a value of the type " + wanted.kind + " expected";
    ParameterDescription description = wanted.description;
    boolean isAllowed =
        ParameterKind.numbers(wanted.value).stream()
            .filter(each -> each.getType() == UDataType.DATA_DOUBLE)
            .allMatch(each -> description.allows(each.doubleValue()));
    return isAllowed
        ? ""
        : "a number from %s to %s expected%s"
            .formatted(
                description.from(),
                description.to(),
                description.step() == 0 ? "" : ", in steps of " + description.step());
  }

  /**
   * Deletes one.
   *
   * @throws RosException if there is none
   */
  synchronized void delete(String name) {
    Parameter known = parameters.remove(name);
    if (known == null) throw new RosException("there is no parameter " + name);
    tell(Change.DELETED, Map.of(name, known));
  }

  // ------------------------------------------------------------------ what others set

  /**
   * Sets several as another node wants it: all or none.
   *
   * @param wanted {@code rcl_interfaces/Parameter}
   * @return why not; empty if they are set
   */
  String setByOthers(List<UDictionary> wanted) {
    Map<String, Parameter> next = new LinkedHashMap<>();
    synchronized (this) {
      for (UDictionary each : wanted) {
        String name = GoalIds.part(each, "name").stringValue();
        UDictionary message = GoalIds.part(each, "value").udictionaryValue();
        ParameterKind kind = ParameterKind.kind(message);
        Parameter known = parameters.get(name);
        if (known == null) return name + " is no parameter of " + node.name();
        if (known.description.readOnly()) return name + " is read-only";
        UValue value = ParameterKind.value(message);
        if (!known.kind.mayBecome(kind)
            || !known.description.type().isEmpty() && !known.kind.fits(value))
          return name + ": a value of the type " + known.kind + " expected, not " + kind;
        Parameter changed =
            new Parameter(known.kind.fits(value) ? known.kind : kind, value, known.description);
        String problem = problem(changed);
        if (!problem.isEmpty()) return name + ": " + problem;
        next.put(name, changed);
      }
      parameters.putAll(next);
      if (!next.isEmpty()) tell(Change.CHANGED, next);
    }
    next.forEach((name, changed) -> {
      set.accept(name, changed.value);
      listeners.forEach(each -> each.accept(name, changed.value));
    });
    return "";
  }

  private void tell(Change change, Map<String, Parameter> which) {
    UList told = new UList();
    which.forEach((name, parameter) ->
        told.add(
            new UValue(
                new UDictionary()
                    .with("name", name)
                    .with("value", parameter.kind.message(valueType, parameter.value)))));
    UDictionary event = Templates.of(events.type());
    event.put("stamp", Templates.time(node.now()));
    event.put("node", node.name());
    event.put(change.field, new UValue(told));
    events.publish(event);
  }
}
