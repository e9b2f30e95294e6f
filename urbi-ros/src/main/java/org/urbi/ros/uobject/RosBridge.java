package org.urbi.ros.uobject;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.bridge.BridgeServer;
import org.urbi.ros.graph.RosException;
import urbi.UDataType;
import urbi.UObject;
import urbi.UValue;
import urbi.UVar;

/** A server for programs and web pages that talk to ROS by rosbridge: {@code Ros.Bridge}. */
public final class RosBridge extends UObject implements AutoCloseable {
  static {
    UStart(RosBridge.class);
  }

  private final UVar host = new UVar();
  private final UVar token = new UVar();
  private final UVar origins = new UVar();
  private @Nullable BridgeServer server;

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
  public int listen(int port) {
    if (server != null) {
      throw new RosException("this bridge listens already, at " + server.port() + ": close it");
    }
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
    BridgeServer opened =
        BridgeServer.open(
            Ros.of(this),
            host.stringValue(),
            port,
            pages,
            token.stringValue(),
            text -> getUContext().report("ROS: " + text));
    server = opened;
    return opened.port();
  }

  /** Where it listens; 0 if it does not. */
  public int port() {
    return server == null ? 0 : server.port();
  }

  /** How many are connected. */
  public int clients() {
    return server == null ? 0 : server.clients();
  }

  /** Ends it, and lets all clients go. */
  @Override
  public void close() {
    if (server != null) {
      server.close();
      server = null;
    }
  }
}
