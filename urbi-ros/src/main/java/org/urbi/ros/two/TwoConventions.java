package org.urbi.ros.two;

import org.urbi.ros.graph.Actions;
import org.urbi.ros.graph.ClockFollower;
import org.urbi.ros.graph.ParameterServer;
import org.urbi.ros.graph.Severity;

/** What makes a node of ROS 2 out of one that has topics and services. */
public final class TwoConventions {
  private final TwoLog log;
  private final TwoActions actions;
  private final TwoParameters parameters;

  /**
   * Offers to others what they expect of a node.
   *
   * @param clock what time it is for the node
   * @param identity what no other node has, 12 bytes at least
   */
  public TwoConventions(TwoHost node, ClockFollower clock, byte[] identity) {
    log = new TwoLog(node);
    actions = new TwoActions(node, identity);
    parameters = new TwoParameters(node, clock);
  }

  /** Tells people something on {@code /rosout}. */
  public void log(Severity severity, String text) {
    log.log(severity, text);
  }

  public Actions actions() {
    return actions;
  }

  public ParameterServer parameters() {
    return parameters;
  }
}
