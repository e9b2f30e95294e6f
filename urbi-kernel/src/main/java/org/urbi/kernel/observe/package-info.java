/** What people who look at a kernel are told of its jobs and tags, and how they control them. */
@NullMarked
package org.urbi.kernel.observe;

import org.jspecify.annotations.NullMarked;
