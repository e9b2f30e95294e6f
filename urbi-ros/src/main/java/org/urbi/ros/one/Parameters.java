package org.urbi.ros.one;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.urbi.ros.graph.ParameterDescription;
import org.urbi.ros.graph.ParameterServer;
import org.urbi.ros.graph.RosException;
import urbi.UBinary;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** The parameters that the master of ROS 1 keeps for all nodes. */
public final class Parameters implements ParameterServer {
  private final Api master;
  private final MasterWatch watch;
  private final OneNode node;
  private final Map<String, Consumer<UValue>> listeners = new LinkedHashMap<>();

  Parameters(Api master, MasterWatch watch, OneNode node) {
    this.master = master;
    this.watch = watch;
    this.node = node;
  }

  @Override
  public CompletableFuture<UValue> get(String name) {
    return master.call(Parameters::value, "getParam", node.resolve(name));
  }

  @Override
  public CompletableFuture<Void> set(String name, UValue value) {
    String full = node.resolve(name);
    Object plain = plain(value);
    return master
        .call(any -> any, "setParam", full, plain)
        // The master does not tell the one who sets it.
        .thenCompose(any -> update(full, plain));
  }

  @Override
  public CompletableFuture<Boolean> has(String name) {
    return master.call(value -> (Boolean) value, "hasParam", node.resolve(name));
  }

  @Override
  public CompletableFuture<Void> delete(String name) {
    String full = node.resolve(name);
    return master
        .call(any -> any, "deleteParam", full)
        // The master tells it later; who has deleted it expects it to be gone now.
        .thenCompose(any -> update(full, Map.of()));
  }

  @Override
  public CompletableFuture<List<String>> names() {
    return master.call(
        value -> ((List<?>) value).stream().map(String.class::cast).toList(), "getParamNames");
  }

  @Override
  public CompletableFuture<Void> declare(
      String name, UValue value, ParameterDescription description) {
    return has(name)
        .thenCompose(
            there -> there ? CompletableFuture.<Void>completedFuture(null) : set(name, value));
  }

  @Override
  public CompletableFuture<List<String>> namesOf(String other) {
    String within = node.resolve(other) + "/";
    return names().thenApply(all -> all.stream().filter(each -> each.startsWith(within)).toList());
  }

  /** Has a listener told the value whenever it is set, and void when it is not any more. */
  public void watch(String name, Consumer<UValue> listener) {
    String full = node.resolve(name);
    synchronized (listeners) {
      listeners.put(full, listener);
    }
    watch.add(
        new Registration("parameter " + full) {
          @Override
          CompletableFuture<?> register(Api told) {
            return told.call(value -> value, "subscribeParam", node.uri(), full)
                .thenCompose(value -> update(full, value));
          }

          @Override
          CompletableFuture<?> unregister(Api told) {
            return told.call(any -> any, "unsubscribeParam", node.uri(), full);
          }
        });
  }

  /**
   * A parameter has been set or, when the value is an empty map, is not there: the master calls it
   * with a slash at the end. Done when those who watch it have been told.
   */
  CompletableFuture<Void> update(String name, Object value) {
    String full = name.replaceAll("(?<=.)/$", "");
    Map<String, Consumer<UValue>> told;
    synchronized (listeners) {
      told = Map.copyOf(listeners);
    }
    boolean unset = value instanceof Map<?, ?> map && map.isEmpty();
    List<CompletableFuture<Void>> asked = new ArrayList<>();
    told.forEach((watched, listener) -> {
      if (watched.equals(full) && !unset) {
        listener.accept(value(value));
      } else if (watched.equals(full) || full.startsWith(watched + "/")) {
        // Of a part the whole is asked for. What is told to be gone may be old news: somebody may
        // have set it since. A master that has gone meanwhile is asked when it is back.
        asked.add(ask(watched).thenAccept(listener).exceptionally(failure -> null));
      }
    });
    return CompletableFuture.allOf(asked.toArray(CompletableFuture<?>[]::new));
  }

  /** The value, or void when the master has none. */
  private CompletableFuture<UValue> ask(String full) {
    return has(full)
        .thenCompose(there -> there ? get(full) : CompletableFuture.completedFuture(new UValue()));
  }

  private static UValue value(Object plain) {
    return switch (plain) {
      case Integer number -> new UValue((double) number);
      case Double number -> new UValue((double) number);
      case Boolean truth -> new UValue((boolean) truth);
      case byte[] bytes -> new UValue(new UBinary(bytes));
      case List<?> list -> {
        UList values = new UList();
        list.forEach(each -> values.add(value(each)));
        yield new UValue(values);
      }
      case Map<?, ?> members -> {
        UDictionary values = new UDictionary();
        members.forEach((name, each) -> values.put(String.valueOf(name), value(each)));
        yield new UValue(values);
      }
      default -> new UValue(String.valueOf(plain));
    };
  }

  private static Object plain(UValue value) {
    return switch (value.getType()) {
      case DATA_DOUBLE -> {
        double number = value.doubleValue();
        if ((int) number == number) {
          yield (int) number;
        }
        yield number;
      }
      case DATA_STRING, DATA_SLOTNAME -> value.stringValue();
      case DATA_BINARY -> value.ubinaryValue().getData();
      case DATA_LIST -> {
        List<Object> list = new ArrayList<>();
        value.ulistValue().forEach(each -> list.add(plain(each)));
        yield list;
      }
      case DATA_DICTIONARY -> {
        Map<String, Object> members = new LinkedHashMap<>();
        value.udictionaryValue().forEach((name, each) -> members.put(name, plain(each)));
        yield members;
      }
      case DATA_VOID ->
          throw new RosException("a parameter is a number, a string, a list or a Dictionary");
    };
  }
}
