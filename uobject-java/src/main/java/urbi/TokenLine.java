package urbi;

import java.nio.charset.StandardCharsets;

/**
 * The first line with which a client authenticates: a comment with a token, which servers without
 * tokens ignore (docs/networking.md).
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
