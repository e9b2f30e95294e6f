package org.urbi.ros.uobject;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.one.OneNode;
import org.urbi.ros.one.OneSettings;
import urbi.UDictionary;
import urbi.UObject;
import urbi.UValue;
import urbi.UVar;

/**
 * This program's node (manual, "Ros"). It is made when it is needed first; until then, {@code
 * masterUri} and {@code packagePath} may be set, which the environment gives otherwise.
 */
public final class Ros extends UObject implements AutoCloseable {
  static {
    UStart(Ros.class);
  }

  private static final String MASTER = "ROS_MASTER_URI";
  private static final String PACKAGES = "ROS_PACKAGE_PATH";

  private final UVar masterUri = new UVar();
  private final UVar packagePath = new UVar();
  private final Map<String, String> remappings = new HashMap<>();
  private @Nullable OneNode node;

  public Ros(String name) {
    super(name);
    UBindVars(masterUri, "masterUri", packagePath, "packagePath");
    masterUri.setValue(System.getenv().getOrDefault(MASTER, "http://localhost:11311"));
    packagePath.setValue(System.getenv().getOrDefault(PACKAGES, ""));
    UBindFunctions(
        "checkMaster",
        "name",
        "version",
        "nodes",
        "topics",
        "services",
        "remap",
        "log",
        "getParam",
        "setParam",
        "hasParam",
        "deleteParam",
        "params");
    bind("Topic", () -> UValue.slotName("RosTopic"));
    bind("Service", () -> UValue.slotName("RosService"));
  }

  /** The one of this kernel, for its topics and services. */
  static OneNode of(UObject asking) {
    if (asking.getUObject("Ros") instanceof Ros ros) {
      return ros.node();
    }
    throw new RosException("the module of ROS is not loaded: loadModule(\"urbi/ros\")");
  }

  private synchronized OneNode node() {
    OneNode known = node;
    if (known == null) {
      Map<String, String> environment = new HashMap<>(System.getenv());
      environment.put(MASTER, masterUri.stringValue());
      environment.put(PACKAGES, packagePath.stringValue());
      ProcessHandle self = ProcessHandle.current();
      long born = self.info().startInstant().map(time -> time.toEpochMilli()).orElse(0L);
      String own = "urbi_" + born + self.pid();
      String uri = masterUri.stringValue();
      known =
          OneNode.start(
              OneSettings.of(environment, own, Map.copyOf(remappings)), there -> told(uri, there));
      node = known;
    }
    return known;
  }

  private void told(String uri, boolean there) {
    getUContext()
        .report(
            there
                ? "ROS: connected to the master " + uri
                : "ROS: no master at " + uri + ", looking for it every second (start roscore)");
  }

  // ------------------------------------------------------------------ what it tells

  /** Whether there is a master. */
  public CompletionStage<Boolean> checkMaster() {
    return node().reachable();
  }

  /** The full name of the node. */
  public String name() {
    return node().name();
  }

  /** Which ROS it is: 1. */
  public int version() {
    return node().version().version();
  }

  /** For each node the topics that it publishes, those to which it subscribes, its services. */
  public CompletionStage<UDictionary> nodes() {
    return node().graph().thenApply(Listings::nodes);
  }

  /** For each topic its type, and the nodes that publish it or subscribe to it. */
  public CompletionStage<UDictionary> topics() {
    return node().graph().thenApply(Listings::topics);
  }

  /** For each service the nodes that provide it. */
  public CompletionStage<UDictionary> services() {
    return node().graph().thenApply(Listings::services);
  }

  /**
   * Tells people something on /rosout.
   *
   * @param level debug, info, warn, error or fatal
   */
  public void log(String level, String text) {
    node().log(level, text);
  }

  // ------------------------------------------------------------------ names and parameters

  /** Has a name mean another one; before the node is used. */
  public synchronized void remap(String from, String to) {
    if (node != null) {
      throw new RosException("names are remapped before Ros is used");
    }
    remappings.put(from, to);
  }

  /** The value of a parameter. */
  public CompletionStage<UValue> getParam(String name) {
    return node().parameters().get(name);
  }

  /** Sets a parameter: a number, a string, a list or a Dictionary. */
  public CompletionStage<Void> setParam(String name, UValue value) {
    return node().parameters().set(name, value);
  }

  /** Whether there is a parameter. */
  public CompletionStage<Boolean> hasParam(String name) {
    return node().parameters().has(name);
  }

  /** Deletes a parameter. */
  public CompletionStage<Void> deleteParam(String name) {
    return node().parameters().delete(name);
  }

  /** The names of all parameters. */
  public CompletionStage<List<String>> params() {
    return node().parameters().names().thenApply(ArrayList::new);
  }

  @Override
  public synchronized void close() {
    if (node != null) {
      node.close();
    }
  }
}
