package org.urbi.ros.two;

import static org.urbi.ros.two.GoalIds.part;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import org.urbi.ros.graph.ClockFollower;
import org.urbi.ros.graph.ParameterDescription;
import org.urbi.ros.graph.ParameterServer;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** The parameters of this node and, by their services, those of other nodes of ROS 2. */
final class TwoParameters implements ParameterServer {
  /** Seconds in which another node answers. */
  private static final int PATIENCE = 10;

  private final TwoHost node;
  private final OwnParameters own;

  /**
   * Whose parameter it is.
   *
   * @param node the full name of the node; empty for this one
   */
  private record Place(String node, String name) {
    boolean isOwn() {
      return node.isEmpty();
    }

    UDictionary asNames() {
      return new UDictionary().with("names", UList.of(name));
    }
  }

  TwoParameters(TwoHost node, ClockFollower clock) {
    this.node = node;
    own =
        new OwnParameters(
            node,
            (name, value) -> {
              if (name.equals(ClockFollower.PARAMETER)) clock.follow(value.booleanValue());
            });
    ParameterDescription flag =
        new ParameterDescription(
            ParameterKind.BOOL.toString(),
            "Use the time of /clock",
            false,
            Double.NaN,
            Double.NaN,
            0);
    own.declare(ClockFollower.PARAMETER, new UValue(0.0), flag);
    ParameterServices.serve(node, own);
  }

  private Place place(String written) {
    int colon = written.indexOf(':');
    if (colon < 0) return new Place("", written);
    String full = node.resolve(written.substring(0, colon));
    return new Place(full.equals(node.name()) ? "" : full, written.substring(colon + 1));
  }

  private Place ownPlace(String written) {
    Place place = place(written);
    if (!place.isOwn())
      throw new RosException("only " + place.node + " declares and deletes its parameters");
    return place;
  }

  /** What a service of another node for its parameters answers. */
  private CompletableFuture<UDictionary> ask(String other, String service, UDictionary request) {
    String full = other + "/" + service;
    return node.typeOfService(full, "there is no node " + other + " that has parameters")
        .thenCompose(type -> node.client(full, node.definitions().service(type), true))
        .thenCompose(client -> answer(client, request));
  }

  private static CompletableFuture<UDictionary> answer(ServiceClient client, UDictionary request) {
    return client
        .request(request)
        .orTimeout(PATIENCE, TimeUnit.SECONDS)
        .whenComplete((answer, failure) -> client.close());
  }

  /** The only answer. Real nodes give none at all if one of the parameters is not there. */
  private static Optional<UValue> only(UDictionary answer, String field) {
    return part(answer, field).ulistValue().stream().findFirst();
  }

  private CompletableFuture<UDictionary> message(Place place) {
    return place.isOwn()
        ? CompletableFuture.completedFuture(own.message(place.name))
        : ask(place.node, "get_parameters", place.asNames())
            .thenApply(answer ->
                only(answer, "values").map(UValue::udictionaryValue).orElseGet(this::notSet));
  }

  @Override
  public CompletableFuture<UValue> get(String name) {
    return message(place(name))
        .thenApply(message -> {
          if (ParameterKind.kind(message) == ParameterKind.NOT_SET)
            throw new RosException("there is no parameter " + name);
          return ParameterKind.value(message);
        });
  }

  @Override
  public CompletableFuture<Boolean> has(String name) {
    return message(place(name))
        .thenApply(message -> ParameterKind.kind(message) != ParameterKind.NOT_SET);
  }

  @Override
  public CompletableFuture<Void> set(String name, UValue value) {
    Place place = place(name);
    if (place.isOwn()) return done(() -> own.set(place.name, value));
    // As the other one has it: it takes no integer for a double.
    return ask(place.node, "get_parameter_types", place.asNames())
        .thenApply(answer -> part(answer, "types").ubinaryValue().getData())
        .thenCompose(types -> {
          ParameterKind known = ParameterKind.of(types.length == 0 ? 0 : types[0]);
          ParameterKind kind = known.fits(value) ? known : ParameterKind.of(value);
          return ask(place.node, "set_parameters", setting(place, kind, value));
        })
        .thenAccept(answer -> {
          UDictionary result =
              only(answer, "results")
                  .map(UValue::udictionaryValue)
                  .orElseThrow(() -> new RosException(place.node + " does not tell of " + name));
          if (!part(result, "successful").booleanValue())
            throw new RosException(name + " is not set: " + part(result, "reason").stringValue());
        });
  }

  private MessageType valueType() {
    return node.definitions().message("rcl_interfaces/ParameterValue");
  }

  private UDictionary notSet() {
    return ParameterKind.NOT_SET.message(valueType(), new UValue());
  }

  private UDictionary setting(Place place, ParameterKind kind, UValue value) {
    UDictionary parameter =
        new UDictionary().with("name", place.name).with("value", kind.message(valueType(), value));
    return new UDictionary().with("parameters", UList.of(parameter));
  }

  private static CompletableFuture<Void> done(Runnable action) {
    action.run();
    return CompletableFuture.completedFuture(null);
  }

  @Override
  public CompletableFuture<Void> declare(
      String name, UValue value, ParameterDescription description) {
    return done(() -> own.declare(ownPlace(name).name, value, description));
  }

  @Override
  public CompletableFuture<Void> delete(String name) {
    return done(() -> own.delete(ownPlace(name).name));
  }

  @Override
  public CompletableFuture<List<String>> names() {
    return CompletableFuture.completedFuture(own.names());
  }

  @Override
  public CompletableFuture<List<String>> namesOf(String other) {
    String full = node.resolve(other);
    if (full.equals(node.name())) return names();
    MessageType request = node.definitions().service("rcl_interfaces/ListParameters").request();
    return ask(full, "list_parameters", Templates.of(request))
        .thenApply(answer -> part(answer, "result").udictionaryValue())
        .thenApply(result ->
            part(result, "names").ulistValue().stream().map(UValue::stringValue).toList());
  }

  @Override
  public void watch(BiConsumer<String, UValue> listener) {
    own.watch(listener);
  }
}
