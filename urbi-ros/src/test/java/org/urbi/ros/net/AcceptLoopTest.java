package org.urbi.ros.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.logging.Logger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.ros.Awaited;

/** Connections that cannot be served: those after them are. */
class AcceptLoopTest {
  private final Logger log = Logger.getLogger("UObjectJava");
  private final List<String> logged = new CopyOnWriteArrayList<>();
  private final List<String> told = new CopyOnWriteArrayList<>();
  private final BlockingQueue<String> events = new LinkedBlockingQueue<>();

  @BeforeEach
  void listen() {
    log.setFilter(entry -> !logged.add(entry.getMessage() + " <- " + entry.getThrown()));
  }

  @AfterEach
  void stopListening() {
    log.setFilter(null);
  }

  /** As when the process has too many files open: so it is with the first connection. */
  private static final class Full extends ServerSocket {
    private boolean wasFull;

    Full() throws IOException {
      super(0, 5, InetAddress.getLoopbackAddress());
    }

    @Override
    public Socket accept() throws IOException {
      if (!wasFull) {
        wasFull = true;
        throw new IOException("Too many open files");
      }
      return super.accept();
    }
  }

  /** The second one finds no memory for a thread, the third one meets a defect. */
  private final class Clients implements AcceptLoop.Clients {
    private int arrived;

    @Override
    public boolean arrives(Socket client) {
      arrived++;
      if (arrived == 2) {
        throw new OutOfMemoryError("unable to create native thread");
      }
      return true;
    }

    @Override
    public void serve(Socket client) throws IOException {
      int word = client.getInputStream().read();
      if (word == 'x') {
        throw new NoClassDefFoundError("lost");
      }
      client.getOutputStream().write(word);
    }

    @Override
    public void leaves(Socket client) {
      events.add("leaves");
    }
  }

  private static int answer(ServerSocket server, char word) throws IOException {
    try (Socket client = new Socket(server.getInetAddress(), server.getLocalPort())) {
      client.getOutputStream().write(word);
      return client.getInputStream().read();
    } catch (IOException e) {
      // It was closed before it was read from.
      return -1;
    }
  }

  @Test
  void acceptingGoesOn() throws Exception {
    Thread loop;
    try (ServerSocket server = new Full()) {
      loop = new Thread(new AcceptLoop("of-test", server, new Clients(), told::add, Duration.ZERO));
      loop.start();
      assertEquals('a', answer(server, 'a'));
      assertEquals(-1, answer(server, 'b'));
      assertEquals(-1, answer(server, 'x'));
      assertEquals('c', answer(server, 'c'));
    }
    loop.join();
    for (int i = 0; i < 4; i++) {
      Awaited.next(events, i);
    }
    // What has ended a thread is logged after it has left.
    Awaited.until("both are logged", () -> logged.size() == 2);
    assertEquals(
        List.of(
            "a connection is refused: Too many open files",
            "a connection is refused: internal error: java.lang.OutOfMemoryError:"
                + " unable to create native thread"),
        told);
    assertEquals(
        List.of(
            "internal error in accepting connections <- java.lang.OutOfMemoryError:"
                + " unable to create native thread",
            "internal error in the thread of-test <- java.lang.NoClassDefFoundError: lost"),
        logged);
    assertFalse(loop.isAlive());
  }
}
