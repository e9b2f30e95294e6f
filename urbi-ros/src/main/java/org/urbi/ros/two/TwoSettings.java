package org.urbi.ros.two;

import java.net.InetAddress;
import java.util.Map;
import org.urbi.ros.graph.Names;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.Definitions;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.InterfaceFiles;

/**
 * Where a node of ROS 2 is.
 *
 * @param domain nodes of other domains are not seen
 * @param address where it listens; on loopback, nodes of this machine only
 */
public record TwoSettings(Names names, int domain, InetAddress address, Definitions definitions) {
  /**
   * What the environment says: {@code ROS_DOMAIN_ID}, {@code ROS_IP} (without it, only this
   * machine's nodes are seen), {@code ROS_NAMESPACE}, {@code AMENT_PREFIX_PATH}.
   *
   * @param node the name of the node, relative or full
   * @throws RosException if something in it is not right
   */
  public static TwoSettings of(
      Map<String, String> environment, String node, Map<String, String> remappings) {
    String domain = environment.getOrDefault("ROS_DOMAIN_ID", "0").strip();
    String address = environment.getOrDefault("ROS_IP", "127.0.0.1").strip();
    try {
      return new TwoSettings(
          Names.of(node, environment.getOrDefault("ROS_NAMESPACE", "/"), remappings),
          Integer.parseInt(domain),
          InetAddress.ofLiteral(address),
          new Definitions(Dialect.ROS_2, InterfaceFiles.of(Dialect.ROS_2, environment)));
    } catch (NumberFormatException e) {
      throw new RosException("ROS_DOMAIN_ID is a number from 0 to 232, and is '" + domain + "'", e);
    } catch (IllegalArgumentException e) {
      throw new RosException("ROS_IP is an address as 192.168.1.2, and is '" + address + "'", e);
    }
  }
}
