package urbi;

import java.nio.charset.StandardCharsets;

/**
 * The line by which a client shows who it is before it says anything else: a comment, which a
 * server that asks nobody passes over (docs/networking.md).
 */
public final class TokenLine {
  /** The system property with the token, which goes before the variable of the environment. */
  public static final String PROPERTY = "urbi.token";

  private TokenLine() {}

  /** The line; empty when the process has no token. */
  public static byte[] bytes() {
    String token = System.getProperty(PROPERTY, System.getenv("URBI_TOKEN"));
    return token == null || token.isBlank()
        ? new byte[0]
        : ("//token " + token.strip() + "\n").getBytes(StandardCharsets.UTF_8);
  }
}
