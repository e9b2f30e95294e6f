package org.urbi.ros.uobject;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.frames.FrameListener;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.Severity;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.Templates;
import org.urbi.ros.one.OneNode;
import org.urbi.ros.one.OneSettings;
import org.urbi.ros.rcl.Middleware;
import org.urbi.ros.two.TwoSettings;
import urbi.UDictionary;
import urbi.UEvent;
import urbi.UObject;
import urbi.UValue;
import urbi.UVar;

/**
 * This program's node (manual, "Ros"), of ROS 1 or ROS 2. It is made when it is needed first; until
 * then, {@code version}, {@code nodeName}, {@code masterUri}, {@code domain} and {@code
 * packagePath} may be set, which the environment gives otherwise.
 */
public final class Ros extends UObject implements AutoCloseable {
  static {
    UStart(Ros.class);
  }

  private static final String MASTER = "ROS_MASTER_URI";
  private static final String DOMAIN = "ROS_DOMAIN_ID";

  private final UVar version = new UVar();
  private final UVar masterUri = new UVar();
  private final UVar domain = new UVar();
  private final UVar packagePath = new UVar();
  private final UVar nodeName = new UVar();
  private final UEvent onNode = new UEvent();
  private final UEvent onNodeGone = new UEvent();
  private final UEvent onTopic = new UEvent();
  private final UEvent onTopicGone = new UEvent();
  private final UEvent onService = new UEvent();
  private final UEvent onServiceGone = new UEvent();
  private final UEvent onParam = new UEvent();
  private final Map<String, String> remappings = new HashMap<>();
  private Dialect dialect = RosVersion.of(System.getenv());
  private @Nullable Node node;
  private @Nullable FrameListener frames;
  private boolean watched;

  public Ros(String name) {
    super(name);
    UBindVars(
        version, "version", masterUri, "masterUri", domain, "domain", packagePath, "packagePath");
    UBindVar(nodeName, "nodeName");
    nodeName.setValue("");
    masterUri.setValue(System.getenv().getOrDefault(MASTER, "http://localhost:11311"));
    domain.setValue(System.getenv().getOrDefault(DOMAIN, "0"));
    version.setValue(dialect.version());
    packagePath.setValue(System.getenv().getOrDefault(packages(dialect), ""));
    UNotifyChange(version, "choose");
    UBindEvent(onNode, "onNode");
    UBindEvent(onNodeGone, "onNodeGone");
    UBindEvent(onTopic, "onTopic");
    UBindEvent(onTopicGone, "onTopicGone");
    UBindEvent(onService, "onService");
    UBindEvent(onServiceGone, "onServiceGone");
    UBindEvent(onParam, "onParam");
    UBindFunctions(
        "checkMaster",
        "name",
        "nodes",
        "topics",
        "services",
        "actions",
        "frames",
        "time",
        "stamp",
        "remap",
        "log",
        "getParam",
        "setParam",
        "hasParam",
        "deleteParam",
        "declareParam",
        "params",
        "paramsOf");
    // Whoever waits for one of the events has it called: ros.u sees to that.
    bind("__watch", this::watch);
    bind(MessageReceiver.TAKE, this::take);
    // ros.u has the usual time and patience.
    bind("__lookup", this::lookup);
    bind("Topic", () -> UValue.slotName("RosTopic"));
    bind("Action", () -> UValue.slotName("RosAction"));
    bind("Service", () -> UValue.slotName("RosService"));
    bind("Bridge", () -> UValue.slotName("RosBridge"));
  }

  /** The one of this kernel, for its topics and services. */
  static Node of(UObject asking) {
    if (asking.getUObject("Ros") instanceof Ros ros) {
      return ros.node();
    }
    throw new RosException("the module of ROS is not loaded: loadModule(\"urbi/ros\")");
  }

  /** Another version has its packages elsewhere; the version of a node that is there remains. */
  public synchronized void choose() {
    try {
      Dialect wanted = RosVersion.of("Ros.version", version.stringValue());
      if (wanted == dialect) {
        return;
      }
      if (node != null) {
        throw new RosException("the version is chosen before Ros is used");
      }
      dialect = wanted;
      packagePath.setValue(System.getenv().getOrDefault(packages(wanted), ""));
    } catch (RosException e) {
      told(String.valueOf(e.getMessage()));
      version.setValue(dialect.version());
    }
  }

  /** Something has come for an object, which may be destroyed by now. */
  public void take(String taker) {
    if (getUObject(taker) instanceof MessageReceiver known) {
      known.take();
    }
  }

  private static String packages(Dialect dialect) {
    return switch (dialect) {
      case ROS_1 -> "ROS_PACKAGE_PATH";
      case ROS_2 -> "AMENT_PREFIX_PATH";
    };
  }

  private synchronized Node node() {
    Node known = node;
    if (known == null) {
      known = start();
      known.parameters().watch((name, value) -> onParam.emit(name, value));
      node = known;
    }
    return known;
  }

  private Node start() {
    Map<String, String> environment = new HashMap<>(System.getenv());
    environment.put(MASTER, masterUri.stringValue());
    environment.put(DOMAIN, domain.stringValue());
    environment.put(packages(dialect), packagePath.stringValue());
    ProcessHandle self = ProcessHandle.current();
    long born = self.info().startInstant().map(time -> time.toEpochMilli()).orElse(0L);
    String given = nodeName.stringValue();
    String own = given.isEmpty() ? "urbi_" + born + self.pid() : given;
    Map<String, String> names = Map.copyOf(remappings);
    String uri = masterUri.stringValue();
    return switch (dialect) {
      case ROS_1 ->
          OneNode.start(OneSettings.of(environment, own, names), there -> told(uri, there));
      case ROS_2 ->
          // Whoever sets packagePath wants other types, and no other middleware.
          Middleware.start(System.getenv(), TwoSettings.of(environment, own, names), this::told);
    };
  }

  private void told(String uri, boolean there) {
    told(
        there
            ? "connected to the master " + uri
            : "no master at " + uri + ", looking for it every second (start roscore)");
  }

  private void told(String text) {
    getUContext().report("ROS: " + text);
  }

  // ------------------------------------------------------------------ what it tells

  /** Whether there is a master; in ROS 2, which has none, whether the node is up. */
  public CompletionStage<Boolean> checkMaster() {
    return node().reachable();
  }

  /** The full name of the node. */
  public String name() {
    return node().name();
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

  /** For each action its type, and the nodes that provide it. */
  public CompletionStage<UDictionary> actions() {
    return node().graph().thenApply(Listings::actions);
  }

  /** From now on the events of the graph are emitted. */
  public synchronized void watch() {
    if (!watched) {
      watched = true;
      GraphChanges.tell(node(), this::changed);
    }
  }

  private void changed(GraphChanges.Kind kind, String name, boolean appeared) {
    UEvent event =
        switch (kind) {
          case NODE -> appeared ? onNode : onNodeGone;
          case TOPIC -> appeared ? onTopic : onTopicGone;
          case SERVICE -> appeared ? onService : onServiceGone;
        };
    event.emit(name);
  }

  /** What time it is for the node, in seconds since 1970; that of /clock with use_sim_time. */
  public double time() {
    return node().now() / 1e9;
  }

  /** The same as messages have it. */
  public UValue stamp() {
    return Templates.time(node().now());
  }

  private synchronized FrameListener frameListener() {
    FrameListener known = frames;
    if (known == null) {
      known = new FrameListener(node(), this::told);
      frames = known;
    }
    return known;
  }

  /** Each frame that was told of on /tf and /tf_static, and the one in which it is. */
  public UDictionary frames() {
    return new UDictionary(frameListener().buffer().parents());
  }

  /**
   * Where a frame was in another one, as {@code geometry_msgs/TransformStamped}. The job waits
   * until that is known.
   *
   * @param time seconds since 1970, or as messages have it; 0 for the newest one that is known
   * @param patience for how many seconds the job waits
   */
  public CompletionStage<UDictionary> lookup(
      String target, String source, UValue time, double patience) {
    return FrameAnswers.lookup(frameListener(), target, source, time, patience);
  }

  /**
   * Tells people something on /rosout.
   *
   * @param level debug, info, warn, error or fatal
   */
  public void log(String level, String text) {
    node().log(Severity.of(level), text);
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

  /** Sets a parameter: a number, a string, a list; in ROS 1 a Dictionary, too. */
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

  /**
   * Sets a parameter of this node if it is not there, and says what it is.
   *
   * @param description what {@link ParameterKeys} knows
   */
  public CompletionStage<Void> declareParam(String name, UValue value, UDictionary description) {
    return node().parameters().declare(name, value, ParameterKeys.of(description));
  }

  /** The names of all parameters; in ROS 2 of those of this node. */
  public CompletionStage<List<String>> params() {
    return node().parameters().names().thenApply(ArrayList::new);
  }

  /** The names of all parameters of a node. */
  public CompletionStage<List<String>> paramsOf(String other) {
    return node().parameters().namesOf(other).thenApply(ArrayList::new);
  }

  @Override
  public synchronized void close() {
    if (node != null) {
      node.close();
    }
  }
}
