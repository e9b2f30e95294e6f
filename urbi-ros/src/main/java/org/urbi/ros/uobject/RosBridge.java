package org.urbi.ros.uobject;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.bridge.BridgeServer;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.RosException;
import urbi.UDataType;
import urbi.UObject;
import urbi.UValue;
import urbi.UVar;
import urbi.thread.GuardedThreads;

/** A server for programs and web pages that talk to ROS by rosbridge: {@code Ros.Bridge}. */
public final class RosBridge extends UObject implements AutoCloseable {
  static {
    UStart(RosBridge.class);
  }

  private final UVar host = new UVar();
  private final UVar token = new UVar();
  private final UVar origins = new UVar();
  private volatile @Nullable BridgeServer server;
  private boolean wanted;

  public RosBridge(String name) {
    super(name);
    UBindVars(host, "host", token, "token", origins, "origins");
    host.setValue("localhost");
    token.setValue("");
    origins.setValue(List.of());
    UBindFunctions("listen", "port", "clients", "close");
  }

  /**
   * Begins to listen; {@code host}, {@code token} and {@code origins} are set before.
   *
   * @param port 0 for any that is free
   * @return the port
   */
  public CompletionStage<Integer> listen(int port) {
    idle();
    if (port < 0 || port > 0xFFFF) {
      throw new RosException("port: 0 to 65535 expected, not " + port);
    }
    if (origins.getUValue().getType() != UDataType.DATA_LIST) {
      throw new RosException("origins: a List expected, as [\"https://robot.example\"]");
    }
    Set<String> pages = new LinkedHashSet<>();
    for (UValue each : origins.ulistValue()) {
      pages.add(each.stringValue());
    }
    want();
    String address = host.stringValue();
    String secret = token.stringValue();
    // It may take long to look up the host: no kernel waits for that, nor who closes the bridge.
    return Ros.of(this)
        .thenApplyAsync(
            node -> open(node, address, port, pages, secret),
            task -> GuardedThreads.SDK.virtual("urbi-ros-bridge-open", task).start());
  }

  private int open(Node node, String address, int port, Set<String> pages, String secret) {
    idle();
    BridgeServer opened =
        BridgeServer.open(
            node, address, port, pages, secret, text -> getUContext().report("ROS: " + text));
    try {
      begin(opened);
    } catch (RosException e) {
      opened.close();
      throw e;
    }
    return opened.port();
  }

  private synchronized void begin(BridgeServer opened) {
    idle();
    if (!wanted) {
      throw new RosException("this bridge was closed before it could listen");
    }
    server = opened;
  }

  private synchronized void want() {
    wanted = true;
  }

  private void idle() {
    BridgeServer present = server;
    if (present != null) {
      throw new RosException("this bridge listens already, at " + present.port() + ": close it");
    }
  }

  /** Where it listens; 0 if it does not. */
  public int port() {
    BridgeServer present = server;
    return present == null ? 0 : present.port();
  }

  /** How many are connected. */
  public int clients() {
    BridgeServer present = server;
    return present == null ? 0 : present.clients();
  }

  /** Ends it, and lets all clients go. */
  @Override
  public synchronized void close() {
    wanted = false;
    BridgeServer present = server;
    server = null;
    if (present != null) {
      present.close();
    }
  }
}
