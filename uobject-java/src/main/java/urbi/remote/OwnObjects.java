package urbi.remote;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import urbi.UClass;
import urbi.UHubClass;
import urbi.UObject;
import urbi.UObjectHub;
import urbi.spi.ComponentFailureLog;
import urbi.spi.Failure;
import urbi.wire.Frame;

/** The classes of a process, and what it has made of them. Any thread may ask. */
final class OwnObjects {
  private final RemoteContext context;
  private final RemoteFunctions functions;
  private final ComponentFailureLog failureLog;
  private final Map<String, UClass> classes = new ConcurrentHashMap<>();
  private final Map<String, UObject> objects = new ConcurrentHashMap<>();
  private final Map<String, String> failures = new ConcurrentHashMap<>();
  private final Map<String, UObjectHub> hubs = new ConcurrentHashMap<>();

  OwnObjects(RemoteContext context, RemoteFunctions functions, ComponentFailureLog failureLog) {
    this.context = context;
    this.functions = functions;
    this.failureLog = failureLog;
  }

  /** Tells the kernel of a class, and makes its first object. */
  void start(UClass type) {
    classes.put(type.name(), type);
    context.inTurn(
        "the constructor of " + type.name(),
        () -> {
          context.ask((out, number) -> out.begin(Frame.CLASS).size(number).text(type.name()).end());
          type.create(type.name());
          // What the constructor has bound is there for everybody when this returns.
          return context.ask((out, number) -> out.begin(Frame.FENCE).size(number).end());
        });
  }

  void start(UHubClass type) {
    context.inTurn("the constructor of " + type.name(), () -> hubs.put(type.name(), type.create()));
  }

  /** Makes an object that the kernel wants; in turn. */
  void make(String className, String name) {
    UClass type = classes.get(className);
    try {
      if (type == null) {
        throw new IllegalStateException("no class " + className);
      }
      context.turn().begin("the constructor of " + name);
      try {
        type.create(name);
      } finally {
        context.turn().end();
      }
    } catch (Throwable e) {
      failureLog.log(className, e);
      failures.put(name, "exception caught while making a " + className + ": " + Failure.text(e));
      objects.remove(name);
      functions.forget(name);
    }
  }

  /**
   * The kernel has destroyed an object; in turn.
   *
   * @return whether it was the last one
   */
  boolean destroyed(String name) {
    failures.remove(name);
    UObject object = objects.get(name);
    if (object == null) {
      return false;
    }
    object.clean();
    return objects.isEmpty();
  }

  /** Adds an object, which is given a name by the kernel if it has none; returns its name. */
  String add(UObject object, @Nullable String name) {
    String known = name;
    if (known == null) {
      String className = object.getUClass().name();
      classes.putIfAbsent(className, object.getUClass());
      known =
          context
              .ask((out, number) -> out.begin(Frame.ATTACH).size(number).text(className).end())
              .stringValue();
    }
    objects.put(known, object);
    return known;
  }

  /** Removes an object with its functions; returns whether it was there. */
  boolean remove(UObject object) {
    String name = object.get__name();
    boolean known = objects.remove(name, object);
    if (known) {
      functions.forget(name);
    }
    return known;
  }

  @Nullable UObject object(String name) {
    return objects.get(name);
  }

  @Nullable UObjectHub hub(String name) {
    return hubs.get(name);
  }

  /** Why an object is not there, or else that. */
  String failure(String object, String otherwise) {
    return failures.getOrDefault(object, otherwise);
  }
}
