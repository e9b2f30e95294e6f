package org.urbi.ros.uobject;

import java.util.concurrent.CompletionStage;
import org.urbi.ros.graph.ActionClient;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UEvent;
import urbi.UObject;
import urbi.UVar;

/**
 * An action of another node, which pursues goals that urbiscript sends. {@code send} and {@code
 * run} are in {@code ros.u}.
 */
public final class RosAction extends UObject implements AutoCloseable {
  static {
    UStart(RosAction.class);
  }

  private final UEvent onFeedback = new UEvent();
  private final UVar seconds = new UVar();
  private final Patience patience;
  private volatile String action = "";
  private final Held<ActionClient> held = new Held<>(ActionClient::close);

  public RosAction(String name) {
    super(name);
    UBindEvent(onFeedback, "onFeedback");
    UBindVar(seconds, "patience");
    patience = new Patience(seconds);
    UBindFunctions("init", "name", "goalStruct", "resultStruct", "feedbackStruct");
  }

  /** Looks the action up. The job waits until it is there. */
  public CompletionStage<Void> init(String name) {
    return held.hold(
        Ros.of(this)
            .thenCompose(node -> {
              action = node.resolve(name);
              return node.actions().client(name, null);
            }),
        () -> {});
  }

  /** What sends goals. */
  ActionClient client() {
    ActionClient known = held.get();
    if (known == null) {
      throw new RosException(action + " is not initialized");
    }
    return known;
  }

  /** For how long the server may take to accept a goal. */
  Patience patience() {
    return patience;
  }

  /** Something has come of one of the goals. */
  void emit(UDictionary feedback) {
    onFeedback.emit(feedback);
  }

  /** The full name of the action. */
  public String name() {
    return action;
  }

  /** A new goal. */
  public UDictionary goalStruct() {
    return Templates.of(client().type().goal());
  }

  /** A new result. */
  public UDictionary resultStruct() {
    return Templates.of(client().type().result());
  }

  /** A new feedback. */
  public UDictionary feedbackStruct() {
    return Templates.of(client().type().feedback());
  }

  @Override
  public void close() {
    held.close();
  }
}
