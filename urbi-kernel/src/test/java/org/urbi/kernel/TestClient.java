package org.urbi.kernel;

import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.urbi.kernel.trust.Role;

/** A client with a role and a budget, and what it hears. */
public final class TestClient implements Client {
  private final Role role;
  private final String budget;
  private final LinkedBlockingQueue<String> heard = new LinkedBlockingQueue<>();
  private final Connection connection;
  private int asked;

  public TestClient(Kernel kernel, Role role) {
    this(kernel, role, "");
  }

  TestClient(Kernel kernel, Role role, String budget) {
    this.role = role;
    this.budget = budget;
    connection = kernel.connect(this, false);
  }

  public Connection connection() {
    return connection;
  }

  @Override
  public void output(String bytes) {
    bytes.lines().forEach(heard::add);
  }

  @Override
  public void closed() {
    heard.add("closed");
  }

  @Override
  public Role role() {
    return role;
  }

  @Override
  public String budget() {
    return budget;
  }

  /** Sends statements; returns what has come until they were over, without time stamps. */
  public String say(String code) {
    String mark = "said " + ++asked;
    connection.send(code + "\nlobby.send(\"" + mark + "\", \"mark\");\n");
    StringBuilder answer = new StringBuilder();
    while (true) {
      String line = next();
      if (line == null || line.equals("closed")) {
        throw new AssertionError("no answer to " + code + " but " + answer);
      }
      if (line.contains(mark)) {
        return answer.toString().strip();
      }
      answer.append(line.replaceFirst("^\\[\\d+(:\\w+)?\\] ", "")).append('\n');
    }
  }

  /** The next line, null if there is none for long. */
  String next() {
    try {
      return heard.poll(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return null;
    }
  }
}
