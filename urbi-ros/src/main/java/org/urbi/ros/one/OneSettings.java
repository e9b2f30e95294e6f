package org.urbi.ros.one;

import java.net.InetAddress;
import java.net.URI;
import java.net.UnknownHostException;
import java.util.Map;
import org.urbi.ros.graph.Names;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.InterfaceFiles;

/**
 * Where a node of ROS 1 is, and where its master.
 *
 * @param bound the address that others can connect to
 * @param host how others are told to call this machine
 */
public record OneSettings(
    URI master, Names names, InetAddress bound, String host, Definitions definitions) {
  private static final String DEFAULT_MASTER = "http://localhost:11311";

  /**
   * What the environment says: {@code ROS_MASTER_URI}, {@code ROS_HOSTNAME} or {@code ROS_IP}
   * (without them, nobody outside this machine can connect), {@code ROS_NAMESPACE}, {@code
   * ROS_PACKAGE_PATH}.
   *
   * @param node the name of the node, relative or full
   * @throws RosException if something in it is not right
   */
  public static OneSettings of(
      Map<String, String> environment, String node, Map<String, String> remappings) {
    String uri = environment.getOrDefault("ROS_MASTER_URI", DEFAULT_MASTER);
    String host =
        environment.getOrDefault("ROS_HOSTNAME", environment.getOrDefault("ROS_IP", "")).strip();
    InetAddress loopback = InetAddress.getLoopbackAddress();
    try {
      URI master = URI.create(uri.strip());
      if (master.getHost() == null || !"http".equals(master.getScheme())) {
        throw new RosException(
            "ROS_MASTER_URI has the form http://host:11311, and is '" + uri + "'");
      }
      boolean local = host.isEmpty() || InetAddress.getByName(host).isLoopbackAddress();
      return new OneSettings(
          master,
          Names.of(node, environment.getOrDefault("ROS_NAMESPACE", "/"), remappings),
          local ? loopback : InetAddress.getByAddress(new byte[4]),
          host.isEmpty() ? loopback.getHostAddress() : host,
          new Definitions(Dialect.ROS_1, InterfaceFiles.of(Dialect.ROS_1, environment)));
    } catch (IllegalArgumentException e) {
      throw new RosException("ROS_MASTER_URI is no address: '" + uri + "'", e);
    } catch (UnknownHostException e) {
      throw new RosException("ROS_HOSTNAME or ROS_IP is no host: '" + host + "'", e);
    }
  }
}
