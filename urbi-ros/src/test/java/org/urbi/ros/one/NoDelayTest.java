package org.urbi.ros.one;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.ros.graph.Qos;

/**
 * {@code tcp_nodelay}: small messages leave at once, ours and those that others send to us. That
 * clients of services ask for it, too, is in {@link HostileServicesTest}.
 */
class NoDelayTest {
  private final InetAddress here = InetAddress.getLoopbackAddress();

  @Test
  void subscribersAskForIt() throws Exception {
    try (ServerSocket data = new ServerSocket(0, 50, here);
        XmlRpcServer other =
            new XmlRpcServer(
                here,
                (method, arguments) ->
                    List.of(1, "", List.of("TCPROS", here.getHostAddress(), data.getLocalPort())));
        OneNode node = OneNodeTest.node(other.port(), "tested")) {
      node.subscribe("/said", null, Qos.DEFAULT, new Heard());
      node.updatePublishers("/said", List.of(URI.create("http://127.0.0.1:" + other.port() + "/")));
      try (TcpRosConnection publisher = new TcpRosConnection(data.accept())) {
        assertEquals("1", publisher.readHeader().get("tcp_nodelay"));
      }
    }
  }

  @Test
  void bothEndsOfAConnectionHaveIt() throws Exception {
    try (ServerSocket data = new ServerSocket(0, 50, here);
        TcpRosConnection asks = TcpRosConnection.to(here.getHostAddress(), data.getLocalPort());
        Socket accepted = data.accept();
        TcpRosConnection asked = new TcpRosConnection(accepted)) {
      assertTrue(accepted.getTcpNoDelay());
    }
  }
}
