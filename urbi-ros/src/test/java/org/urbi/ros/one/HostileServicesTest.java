package org.urbi.ros.one;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.ros.Awaited;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.ServiceClient;
import org.urbi.ros.message.ServiceType;
import org.urbi.ros.message.Templates;
import org.urbi.ros.message.TypeHash;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** Services that do not answer, and clients that do not listen. The master is one of ours. */
class HostileServicesTest {
  private final InetAddress here = InetAddress.getLoopbackAddress();
  private ServerSocket service;
  private XmlRpcServer master;
  private OneNode node;
  private ServiceType flip;
  private ServiceType info;

  @BeforeEach
  void start() throws IOException {
    service = new ServerSocket(0, 50, here);
    String address = "rosrpc://" + here.getHostAddress() + ":" + service.getLocalPort();
    master =
        new XmlRpcServer(
            here,
            (method, arguments) ->
                List.of(1, "", method.equals("lookupService") ? address : (Object) 0));
    node = OneNodeTest.node(master.port(), "tested");
    flip = node.definitions().service("std_srvs/SetBool");
    info = node.definitions().service("sensor_msgs/SetCameraInfo");
  }

  @AfterEach
  void end() throws IOException {
    node.close();
    master.close();
    service.close();
  }

  /** The other end of a connection that our client makes. */
  private TcpRosConnection accept() throws IOException {
    TcpRosConnection connection = new TcpRosConnection(service.accept());
    assertEquals("1", connection.readHeader().get("tcp_nodelay"));
    connection.sendHeader(Map.of("callerid", "/raw"));
    return connection;
  }

  private static void answer(TcpRosConnection connection) throws IOException {
    connection.writeByte(1);
    connection.write(new byte[5]);
    connection.flush();
  }

  private static UDictionary flip(boolean data) {
    return new UDictionary().with("data", data);
  }

  /** More than what the system keeps for a peer. */
  private UDictionary large() {
    UList numbers = new UList();
    for (int i = 0; i < 1_000_000; i++) {
      numbers.add(new UValue(0));
    }
    UDictionary request = Templates.of(info.request());
    request.get("camera_info").udictionaryValue().put("D", new UValue(numbers));
    return request;
  }

  @Test
  void nobodyWaitsForAServiceThatReadsNothing() throws Exception {
    UDictionary request = large();
    for (boolean keepAlive : new boolean[] {false, true}) {
      ServiceClient client = Awaited.value(node.client("/deaf", info, keepAlive));
      CompletableFuture<UDictionary> answer =
          Awaited.value(CompletableFuture.supplyAsync(() -> client.request(request)));
      try (TcpRosConnection connection = accept()) {
        assertFalse(answer.isDone());
        client.close();
        CompletionException told =
            assertThrows(CompletionException.class, () -> Awaited.value(answer));
        assertEquals("/deaf: closed", told.getCause().getMessage());
      }
    }
  }

  /** What nobody waits for any more is not asked, nor asked again. */
  @Test
  void aServiceThatDoesNotAnswer() throws Exception {
    ServiceClient client = Awaited.value(node.client("/mute", flip, true));
    CompletableFuture<UDictionary> answered = client.request(flip(true));
    CompletableFuture<UDictionary> late;
    CompletableFuture<UDictionary> last;
    try (TcpRosConnection connection = accept()) {
      connection.read();
      answer(connection);
      Awaited.value(answered);
      late = client.request(flip(true));
      CompletableFuture<UDictionary> waiting = client.request(flip(true));
      last = client.request(flip(false));
      connection.read();
      waiting.completeExceptionally(new TimeoutException());
      late.completeExceptionally(new TimeoutException());
      assertThrows(EOFException.class, connection::read);
    }
    try (TcpRosConnection connection = accept()) {
      assertEquals(0, connection.read().get());
      answer(connection);
      assertFalse(Awaited.value(last).get("success").booleanValue());
    }
  }

  /** What it was asked it may have done: that is not asked again, but told. */
  @Test
  void aServiceThatGoesBeforeItAnswers() throws Exception {
    ServiceClient client = Awaited.value(node.client("/mute", flip, true));
    CompletableFuture<UDictionary> first = client.request(flip(true));
    try (TcpRosConnection connection = accept()) {
      connection.read();
      answer(connection);
      Awaited.value(first);
      CompletableFuture<UDictionary> lost = client.request(flip(true));
      connection.read();
      connection.close();
      CompletionException told = assertThrows(CompletionException.class, () -> Awaited.value(lost));
      assertEquals("/mute: the peer has closed the connection", told.getCause().getMessage());
    }
    CompletableFuture<UDictionary> next = client.request(flip(false));
    try (TcpRosConnection connection = accept()) {
      assertEquals(0, connection.read().get());
      answer(connection);
      Awaited.value(next);
    }
  }

  /** What it has not been asked yet is asked by a new connection. */
  @Test
  void aServiceThatGoesBetweenRequests() throws Exception {
    ServiceClient client = Awaited.value(node.client("/mute", flip, true));
    for (int i = 0; i < 3; i++) {
      CompletableFuture<UDictionary> answered = client.request(flip(true));
      try (TcpRosConnection connection = accept()) {
        connection.read();
        answer(connection);
        Awaited.value(answered);
      }
    }
  }

  /** It keeps its own thread, and nobody else's; and that goes with it. */
  @Test
  void aClientThatDoesNotListen() throws Exception {
    UDictionary response =
        Templates.of(info.response()).with("status_message", "x".repeat(1_000_000));
    node.serve("/ours", info, asked -> CompletableFuture.completedFuture(response));
    byte[] request = MessageCodec.of(info.request()).encode(Templates.of(info.request()));
    List<TcpRosConnection> deaf = new ArrayList<>();
    for (int i = 0; i < 20; i++) {
      TcpRosConnection each = client("/ours", info);
      deaf.add(each);
      each.readHeader();
      for (int k = 0; k < 20; k++) {
        each.write(request);
      }
      each.flush();
    }
    try (TcpRosConnection well = client("/ours", info)) {
      well.readHeader();
      well.write(request);
      well.flush();
      well.readByte();
      assertTrue(well.read().remaining() > 1_000_000);
    }
    deaf.forEach(TcpRosConnection::close);
    Awaited.until("the threads of those who have gone end", () -> threads() == 0);
  }

  private TcpRosConnection client(String name, ServiceType type) throws IOException {
    TcpRosConnection connection = TcpRosConnection.to(here.getHostAddress(), node.port());
    connection.sendHeader(
        Map.of(
            ConnectionHeader.CALLER,
            "/raw",
            ConnectionHeader.SERVICE,
            node.resolve(name),
            ConnectionHeader.MD5,
            TypeHash.md5(type),
            ConnectionHeader.PERSISTENT,
            "1"));
    return connection;
  }

  private static long threads() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(each -> each.getName().equals("urbi-ros-service"))
        .count();
  }
}
