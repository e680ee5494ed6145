// SPDX-License-Identifier: Apache-2.0
/** What went wrong, in its own words. */
export const reason_of = (error: unknown): string => (error instanceof Error ? error.message : String(error));
