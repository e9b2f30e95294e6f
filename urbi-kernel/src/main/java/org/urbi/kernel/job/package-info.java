/** Jobs, tags' scopes and the tick loop which runs them; knows nothing of urbiscript code. */
@NullMarked
package org.urbi.kernel.job;

import org.jspecify.annotations.NullMarked;
