package org.urbi.server.remote;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/** Passes datagrams on between a process and a server, or loses, repeats and delays them. */
final class UdpRelay implements AutoCloseable {
  private final DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
  private final SocketAddress server;
  private final List<byte[]> toServer = new ArrayList<>();
  private volatile Function<byte[], List<byte[]>> fate = List::of;
  private volatile SocketAddress process;

  UdpRelay(int serverPort) throws IOException {
    server = new InetSocketAddress(InetAddress.getLoopbackAddress(), serverPort);
    Thread.ofPlatform().daemon().name("relay").start(this::pass);
  }

  int port() {
    return socket.getLocalPort();
  }

  /** What becomes of the datagrams with data, in either direction. */
  void setFate(Function<byte[], List<byte[]>> decision) {
    fate = decision;
  }

  /** The datagrams with data that the process has sent. */
  List<byte[]> toServer() {
    synchronized (toServer) {
      return List.copyOf(toServer);
    }
  }

  static boolean hasData(byte[] datagram) {
    return (datagram[1] & 0x7f) == 96;
  }

  private void pass() {
    byte[] bytes = new byte[1 << 16];
    try {
      socket.setReceiveBufferSize(4 << 20);
      while (true) {
        DatagramPacket packet = new DatagramPacket(bytes, bytes.length);
        socket.receive(packet);
        byte[] datagram = java.util.Arrays.copyOf(bytes, packet.getLength());
        boolean fromServer = packet.getSocketAddress().equals(server);
        if (!fromServer) {
          process = packet.getSocketAddress();
        }
        SocketAddress to = fromServer ? process : server;
        if (!hasData(datagram)) {
          send(datagram, to);
          continue;
        }
        if (!fromServer) {
          synchronized (toServer) {
            toServer.add(datagram);
          }
        }
        for (byte[] each : fate.apply(datagram)) {
          send(each, to);
        }
      }
    } catch (IOException e) {
      // Closed.
    }
  }

  void send(byte[] datagram, SocketAddress to) throws IOException {
    socket.send(new DatagramPacket(datagram, datagram.length, to));
  }

  @Override
  public void close() {
    socket.close();
  }
}
