package org.urbi.ros.uobject;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.frames.FrameListener;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.ParameterDescription;
import org.urbi.ros.graph.ParameterServer;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.Severity;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UEvent;
import urbi.UObject;
import urbi.UValue;
import urbi.UVar;

/**
 * This program's node (manual, "Ros"), of ROS 1 or ROS 2. It is made when it is needed first, by
 * another thread: the job that needs it waits, and no other. Until then, {@code version}, {@code
 * nodeName}, {@code masterUri}, {@code domain} and {@code packagePath} may be set, which the
 * environment gives otherwise.
 */
public final class Ros extends UObject implements AutoCloseable {
  static {
    UStart(Ros.class);
  }

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
  private final Map<String, String> remappings = new ConcurrentHashMap<>();
  private final NodeSettings.Maker maker;
  private final FirstUse node = new FirstUse();

  /** Of the recorded run, in a replay. */
  private final Map<String, String> environment = getUContext().environment();

  private volatile Dialect dialect = RosVersion.of(environment);
  private @Nullable FrameListener frames;
  private boolean watched;

  public Ros(String name) {
    this(name, NodeSettings::start);
  }

  /**
   * With a node of somebody else's.
   *
   * @param maker is called by a thread of its own
   */
  Ros(String name, NodeSettings.Maker maker) {
    super(name);
    this.maker = maker;
    UBindVars(
        version, "version", masterUri, "masterUri", domain, "domain", packagePath, "packagePath");
    UBindVar(nodeName, "nodeName");
    nodeName.setValue("");
    masterUri.setValue(environment.getOrDefault(NodeSettings.MASTER, "http://localhost:11311"));
    domain.setValue(environment.getOrDefault(NodeSettings.DOMAIN, "0"));
    version.setValue(dialect.version());
    packagePath.setValue(environment.getOrDefault(NodeSettings.packages(dialect), ""));
    UNotifyChange(version, "choose");
    for (UVar each : List.of(nodeName, masterUri, domain, packagePath)) {
      UNotifyChange(each, "keep");
    }
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
    // The server calls it that loads the module by itself.
    bind("__ahead", this::ahead);
    bind(MessageReceiver.TAKE, this::take);
    // ros.u has the usual time and patience.
    bind("__lookup", this::lookup);
    bind("Topic", () -> UValue.slotName("RosTopic"));
    bind("Action", () -> UValue.slotName("RosAction"));
    bind("Service", () -> UValue.slotName("RosService"));
    bind("Bridge", () -> UValue.slotName("RosBridge"));
  }

  /**
   * The one of this kernel, for its topics and services. It may have to be made, by another thread.
   */
  static CompletionStage<Node> of(UObject asking) {
    if (asking.getUObject("Ros") instanceof Ros ros) {
      return ros.node();
    }
    throw new RosException("the module of ROS is not loaded: loadModule(\"urbi/ros\")");
  }

  /** Another version has its packages elsewhere; the version of a node that is there remains. */
  public void choose() {
    try {
      Dialect wanted = RosVersion.of("Ros.version", version.stringValue());
      if (wanted == dialect) {
        return;
      }
      if (node.used() != null) {
        throw new RosException("the version is chosen before Ros is used");
      }
      dialect = wanted;
      // Who hears of it may let others run, who use Ros, too: no monitor is held.
      packagePath.setValue(environment.getOrDefault(NodeSettings.packages(wanted), ""));
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

  private CompletionStage<Node> node() {
    return node.node(settings(), this::begin);
  }

  /**
   * Makes the node before anybody asks for it, so that others see it, and people are told whether
   * there is a master. What is set until somebody does still counts.
   */
  public CompletionStage<Void> ahead() {
    return node.ahead(settings(), this::begin).thenAccept(made -> {});
  }

  private NodeSettings settings() {
    return new NodeSettings(
        dialect,
        nodeName.stringValue(),
        masterUri.stringValue(),
        domain.stringValue(),
        packagePath.stringValue(),
        Map.copyOf(remappings),
        environment);
  }

  /** What was set of a node that somebody uses already is told, and taken back. */
  public void keep() {
    NodeSettings used = node.used();
    if (used != null) {
      restore("nodeName", nodeName, used.name());
      restore("masterUri", masterUri, used.masterUri());
      restore("domain", domain, used.domain());
      restore("packagePath", packagePath, used.packagePath());
    }
  }

  private void restore(String name, UVar setting, String chosen) {
    if (!setting.stringValue().equals(chosen)) {
      told(name + " is chosen before Ros is used");
      setting.setValue(chosen);
    }
  }

  private Node begin(NodeSettings settings) {
    Node made = maker.make(settings, this::told);
    made.parameters().watch((name, value) -> onParam.emit(name, value));
    return made;
  }

  private void told(String text) {
    getUContext().report("ROS: " + text);
  }

  // ------------------------------------------------------------------ what it tells

  /** Whether there is a master; in ROS 2, which has none, whether the node is up. */
  public CompletionStage<Boolean> checkMaster() {
    return node().thenCompose(Node::reachable);
  }

  /** The full name of the node. */
  public CompletionStage<String> name() {
    return node().thenApply(Node::name);
  }

  /** For each node the topics that it publishes, those to which it subscribes, its services. */
  public CompletionStage<UDictionary> nodes() {
    return graph().thenApply(Listings::nodes);
  }

  /** For each topic its type, and the nodes that publish it or subscribe to it. */
  public CompletionStage<UDictionary> topics() {
    return graph().thenApply(Listings::topics);
  }

  /** For each service the nodes that provide it. */
  public CompletionStage<UDictionary> services() {
    return graph().thenApply(Listings::services);
  }

  /** For each action its type, and the nodes that provide it. */
  public CompletionStage<UDictionary> actions() {
    return graph().thenApply(Listings::actions);
  }

  private CompletionStage<GraphSnapshot> graph() {
    return node().thenCompose(Node::graph);
  }

  /** From now on the events of the graph are emitted. */
  public CompletionStage<Void> watch() {
    return node().thenAccept(this::look);
  }

  private synchronized void look(Node known) {
    if (!watched) {
      watched = true;
      GraphChanges.tell(known, this::changed);
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
  public CompletionStage<Double> time() {
    return node().thenApply(known -> known.now() / 1e9);
  }

  /** The time as the stamp of a message. */
  public CompletionStage<UValue> stamp() {
    return node().thenApply(known -> Templates.time(known.now()));
  }

  private CompletionStage<FrameListener> frameListener() {
    return node().thenApply(this::frameListener);
  }

  private synchronized FrameListener frameListener(Node there) {
    FrameListener known = frames;
    if (known == null) {
      known = new FrameListener(there, this::told);
      frames = known;
    }
    return known;
  }

  /** Each frame that was told of on /tf and /tf_static, and the one in which it is. */
  public CompletionStage<UDictionary> frames() {
    return frameListener().thenApply(there -> new UDictionary(there.buffer().parents()));
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
    FrameAnswers.Question question = FrameAnswers.Question.of(target, source, time, patience);
    return frameListener().thenCompose(question::ask);
  }

  /**
   * Tells people something on /rosout.
   *
   * @param level debug, info, warn, error or fatal
   */
  public CompletionStage<Void> log(String level, String text) {
    Severity severity = Severity.of(level);
    return node().thenAccept(known -> known.log(severity, text));
  }

  // ------------------------------------------------------------------ names and parameters

  /** Has a name mean another one; before the node is used. */
  public void remap(String from, String to) {
    if (node.used() != null) {
      throw new RosException("names are remapped before Ros is used");
    }
    remappings.put(from, to);
  }

  private CompletionStage<ParameterServer> parameters() {
    return node().thenApply(Node::parameters);
  }

  /** The value of a parameter. */
  public CompletionStage<UValue> getParam(String name) {
    return parameters().thenCompose(there -> there.get(name));
  }

  /** Sets a parameter: a number, a string, a list; in ROS 1 a Dictionary, too. */
  public CompletionStage<Void> setParam(String name, UValue value) {
    return parameters().thenCompose(there -> there.set(name, value));
  }

  /** Whether there is a parameter. */
  public CompletionStage<Boolean> hasParam(String name) {
    return parameters().thenCompose(there -> there.has(name));
  }

  /** Deletes a parameter. */
  public CompletionStage<Void> deleteParam(String name) {
    return parameters().thenCompose(there -> there.delete(name));
  }

  /**
   * Sets a parameter of this node if it is not there, and says what it is.
   *
   * @param description what {@link ParameterKeys} knows
   */
  public CompletionStage<Void> declareParam(String name, UValue value, UDictionary description) {
    ParameterDescription described = ParameterKeys.of(description);
    return parameters().thenCompose(there -> there.declare(name, value, described));
  }

  /** The names of all parameters; in ROS 2 of those of this node. */
  public CompletionStage<List<String>> params() {
    return parameters().thenCompose(there -> there.names()).thenApply(ArrayList::new);
  }

  /** The names of all parameters of a node. */
  public CompletionStage<List<String>> paramsOf(String other) {
    return parameters().thenCompose(there -> there.namesOf(other)).thenApply(ArrayList::new);
  }

  @Override
  public void close() {
    node.close();
  }
}
